#include "import_app.h"

#include <iostream>
#include <memory>
#include <ostream>

#include "flownav/cli/exit_status.h"
#include "flownav/cli/progress.h"
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

std::unique_ptr<io::ImageSequence> open_sequence(const ImportOptions& o) {
    switch (o.kind) {
        case ImportKind::KittiOdometry:
            return std::make_unique<io::KittiOdometry>(o.source, o.part, o.mount);
        case ImportKind::KittiRaw:
            return std::make_unique<io::KittiRaw>(o.source, o.part, o.rate_hz.value_or(kitti_rate_hz),
                                                  o.mount);
        case ImportKind::Images:
            return std::make_unique<io::ImageFolder>(o.source, o.camera, io::FrameTimes{o.times, o.rate_hz});
        case ImportKind::Video:
            return std::make_unique<io::VideoFile>(o.source, o.camera, o.rate_hz);
    }
    return nullptr;
}

std::string gyro_words(std::uint64_t readings) {
    return ", " + std::to_string(readings) + " readings of a gyro";
}

int report_problems(const io::ImageSequence& sequence, std::ostream& error) {
    const auto& problems = sequence.problems();
    for (std::size_t i = 0; i < problems.size() && i < problems_shown; ++i) {
        error << "flownav-import: " << problems[i] << '\n';
    }
    if (problems.size() > problems_shown) {
        error << "flownav-import: and " << problems.size() - problems_shown << " more\n";
    }
    return cli::exit_code(problems.empty() ? cli::ExitStatus::Fine : cli::ExitStatus::Input);
}

int run(const ImportOptions& options, std::ostream& out, std::ostream& error) {
    const auto sequence = open_sequence(options);
    const auto* folder = dynamic_cast<const io::ImageFolder*>(sequence.get());
    if (folder != nullptr && !options.quiet) out << "times: " << folder->times_source() << '\n';
    cli::Progress progress(
        std::cout, options.quiet ? cli::Progress::Style::Silent : cli::Progress::style_for(std::cout));
    io::RecordingOptions recording;
    recording.output = options.output;
    recording.camera_label = options.camera.camera_label;
    recording.interlaced = options.camera.interlaced;
    recording.progress = [&progress](double share, std::uint64_t fields) { progress.update(share, fields); };
    const io::RecordingCounts counts = io::write_recording(*sequence, recording);
    progress.finish(counts.fields);
    if (!options.quiet) {
        out << options.output.string() << ": " << counts.fields << " images, " << counts.poses
            << " poses of ground truth" << (counts.gyro > 0 ? gyro_words(counts.gyro) : "") << '\n';
    }
    return report_problems(*sequence, error);
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
