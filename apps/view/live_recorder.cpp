#include "live_recorder.h"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>
#include <unistd.h>

#include <cstdlib>

#include "flownav/io/observations.h"
#include "flownav/io/output_file.h"
#include "flownav/io/rawlog_reader.h"

namespace flownav::view {

namespace {

/// Creates an empty temporary file.
std::filesystem::path temporary_file() {
    std::string name = (std::filesystem::temp_directory_path() / "flownav-view-XXXXXX").string();
    const int descriptor = ::mkstemp(name.data());
    if (descriptor < 0) throw io::OutputError("cannot write a temporary file like " + name);
    ::close(descriptor);
    return name;
}

}  // namespace

LiveRecorder::LiveRecorder(const std::string& ini_file)
    : fields_(io::read_producer_settings(ini_file)), file_(temporary_file()) {
    stream_.reset(std::fopen(file_.c_str(), "wbe"));
    if (!stream_) throw io::OutputError("cannot write " + file_.string());
    while (!any_field_ && copy_next()) {
    }
    if (!any_field_) {
        std::filesystem::remove(file_);
        throw io::InputError(source() + " gave no field: " + problem());
    }
    thread_ = std::thread([this] { run(); });
}

LiveRecorder::~LiveRecorder() {
    leave_ = true;
    if (thread_.joinable()) thread_.join();
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
}

config::Config LiveRecorder::config() const {
    config::Config config = fields_.settings().config;
    const std::string label = config.camera.camera_label;
    config.camera = {};
    config.camera.camera_label = label;
    return config;
}

std::string LiveRecorder::problem() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return problem_;
}

void LiveRecorder::stop(const std::string& problem) {
    const std::lock_guard<std::mutex> lock(mutex_);
    problem_ = problem;
}

bool LiveRecorder::copy_next() {
    const auto event = fields_.next();
    if (!event) {
        stop(fields_.error().empty() ? "the source is at its end" : fields_.error());
        return false;
    }
    if (const auto* field = std::get_if<Field>(&*event)) {
        write(*io::image_observation(*field, fields_.settings().config.camera.camera_label));
        any_field_ = true;
    } else if (const auto* sample = std::get_if<io::PoseSample>(&*event)) {
        if (sample->source == io::PoseSample::Source::Odometry) write(*io::odometry_observation(*sample));
    }
    return true;
}

void LiveRecorder::write(const mrpt::obs::CObservation& observation) {
    mrpt::io::CMemoryStream memory;
    auto archive = mrpt::serialization::archiveFrom(memory);
    archive << observation;
    const std::size_t count = memory.getTotalBytesCount();
    const bool whole = std::fwrite(memory.getRawBufferData(), 1, count, stream_.get()) == count &&
                       std::fflush(stream_.get()) == 0;
    if (!whole) throw io::OutputError("cannot write " + file_.string() + ": is the disk full?");
}

void LiveRecorder::run() {
    try {
        while (!leave_ && copy_next()) {
        }
    } catch (const std::exception& error) {
        stop(error.what());
    }
}

}  // namespace flownav::view
