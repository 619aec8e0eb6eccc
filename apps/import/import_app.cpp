#include "import_app.h"

#include <iostream>
#include <memory>
#include <ostream>
#include <utility>

#include "flownav/cli/exit_status.h"
#include "flownav/cli/progress.h"
#include "flownav/io/data_set_folder.h"
#include "flownav/io/image_folder.h"
#include "flownav/io/kitti.h"
#include "flownav/io/output_file.h"
#include "flownav/io/rawlog_reader.h"
#include "flownav/io/recording_writer.h"
#include "flownav/io/video_file.h"
#include "import_options.h"

namespace flownav {
namespace {

constexpr double kitti_rate_hz = 10.0;
constexpr std::size_t problems_shown = 5;

/// An open data set, and where its times come from; empty when there is nothing to tell.
struct Opened {
    std::unique_ptr<io::ImageSequence> sequence;
    std::string times_source;
};

template <class Sequence>
Opened with_source(std::unique_ptr<Sequence> sequence) {
    std::string source = sequence->times_source();
    return {std::move(sequence), std::move(source)};
}

Opened open_data_set(const ImportOptions& o, io::DataSetKind kind) {
    return with_source(std::make_unique<io::DataSetFolder>(o.source, kind, o.camera, o.times_unit));
}

Opened open_images(const ImportOptions& o) {
    const auto kind = io::data_set_kind(o.source);
    if (kind != io::DataSetKind::None && o.times.empty() && !o.rate_hz) return open_data_set(o, kind);
    const io::FrameTimes times{o.times, o.rate_hz, io::FrameTimes().default_rate_hz, o.times_unit};
    return with_source(std::make_unique<io::ImageFolder>(o.source, o.camera, times));
}

Opened open_sequence(const ImportOptions& o) {
    switch (o.kind) {
        case ImportKind::KittiOdometry:
            return {std::make_unique<io::KittiOdometry>(o.source, o.part, o.mount), ""};
        case ImportKind::KittiRaw:
            return {
                std::make_unique<io::KittiRaw>(o.source, o.part, o.rate_hz.value_or(kitti_rate_hz), o.mount),
                ""};
        case ImportKind::Tum:
            return open_data_set(o, io::DataSetKind::Tum);
        case ImportKind::Euroc:
            return open_data_set(o, io::DataSetKind::Euroc);
        case ImportKind::Images:
            return open_images(o);
        case ImportKind::Video:
            return {std::make_unique<io::VideoFile>(o.source, o.camera, o.rate_hz), ""};
    }
    return {};
}

std::string gyro_words(std::uint64_t readings) {
    return ", " + std::to_string(readings) + " readings of a gyro";
}

/// Writes at most `problems_shown` of these sentences, and the number of the others.
void report(const std::vector<std::string>& sentences, std::ostream& error) {
    for (std::size_t i = 0; i < sentences.size() && i < problems_shown; ++i)
        error << "flownav-import: " << sentences[i] << '\n';
    if (sentences.size() > problems_shown)
        error << "flownav-import: and " << sentences.size() - problems_shown << " more\n";
}

/// Tells what was recognised and what is missing. Returns the exit status.
int report_input(const io::ImageSequence& sequence, std::uint64_t images, std::ostream& error) {
    report(sequence.notes(), error);
    const auto& problems = sequence.problems();
    report(problems, error);
    if (problems.empty()) return cli::exit_code(cli::ExitStatus::Fine);
    error << "flownav-import: part of the recording is missing; the other " << images
          << (images == 1 ? " image was written\n" : " images were written\n");
    return cli::exit_code(cli::ExitStatus::Input);
}

int run(const ImportOptions& options, std::ostream& out, std::ostream& error) {
    const Opened opened = open_sequence(options);
    io::ImageSequence& sequence = *opened.sequence;
    if (!opened.times_source.empty() && !options.quiet) out << "times: " << opened.times_source << '\n';
    cli::Progress progress(
        std::cout, options.quiet ? cli::Progress::Style::Silent : cli::Progress::style_for(std::cout));
    io::RecordingOptions recording;
    recording.output = options.output;
    recording.camera_label = options.camera.camera_label;
    recording.interlaced = options.camera.interlaced;
    recording.progress = [&progress](double share, std::uint64_t fields) { progress.update(share, fields); };
    const io::RecordingCounts counts = io::write_recording(sequence, recording);
    progress.finish(counts.fields);
    if (!options.quiet) {
        out << options.output.string() << ": " << counts.fields << " images, " << counts.poses
            << " poses of ground truth" << (counts.gyro > 0 ? gyro_words(counts.gyro) : "") << '\n';
    }
    return report_input(sequence, counts.frames, error);
}

}  // namespace

int run_import_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error) {
    const auto fail = [&error](const std::exception& exception, cli::ExitStatus status) {
        error << "flownav-import: " << exception.what() << '\n';
        return cli::exit_code(status);
    };
    try {
        int status = 0;
        const auto options = parse_import_options(arguments, out, error, status);
        return options ? run(*options, out, error) : status;
    } catch (const io::OutputError& exception) {
        return fail(exception, cli::ExitStatus::Output);
    } catch (const std::exception& exception) {
        return fail(exception, cli::ExitStatus::Usage);
    }
}

}  // namespace flownav
