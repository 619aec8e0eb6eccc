#include "flownav/replay/recording_writer.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <opencv2/core/mat.hpp>
#include <system_error>

#include "flownav/replay/output_file.h"
#include "flownav/replay/rawlog_reader.h"
#include "flownav/sensor/camera_conversion.h"
#include "flownav/sensor/field_splitter.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;

/// A file that gets its name when it is complete, and is removed otherwise. Anything but a regular file, such
/// as a device, is written in place.
class PendingFile {
  public:
    explicit PendingFile(const fs::path& target) : target_(target), path_(target) {
        std::error_code error;
        const auto status = fs::status(target, error);
        if (fs::is_directory(status)) throw OutputError("cannot write " + target.string() + ": is a folder");
        if (!fs::exists(status) || fs::is_regular_file(status)) path_ += ".part";
    }
    ~PendingFile() {
        std::error_code error;
        if (!done_ && path_ != target_) fs::remove(path_, error);
    }
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    const fs::path& path() const { return path_; }

    void complete() {
        std::error_code error;
        if (path_ != target_) fs::rename(path_, target_, error);
        if (error) throw OutputError("cannot write " + target_.string() + ": " + error.message());
        done_ = true;
    }

  private:
    fs::path target_;
    fs::path path_;
    bool done_ = false;
};

/// Writes observations of one recording.
class Recording {
  public:
    Recording(const fs::path& path, std::string camera_label)
        : file_(path), label_(std::move(camera_label)) {}

    void write(const Field& field) {
        // OpenCV has no view of constant pixels; the clone only reads.
        const cv::Mat view(field.image.height_px, field.image.width_px, CV_8UC1,
                           const_cast<std::uint8_t*>(field.image.data),
                           static_cast<std::size_t>(field.image.stride_bytes));
        mrpt::obs::CObservationImage image;
        image.timestamp = mrpt::Clock::fromDouble(field.timestamp_s);
        image.sensorLabel = label_;
        image.cameraPose = camera_pose(field.camera.mount);
        image.cameraParams = camera_params(field.camera);
        image.image = mrpt::img::CImage(view.clone(), mrpt::img::SHALLOW_COPY);
        write_object(file_, image);
    }

    void write(double timestamp_s, const Pose2& T_start_robot) {
        mrpt::obs::CObservationRobotPose pose;
        pose.timestamp = mrpt::Clock::fromDouble(timestamp_s);
        pose.sensorLabel = "GROUND_TRUTH";
        pose.pose.mean =
            mrpt::poses::CPose3D(T_start_robot.x_m, T_start_robot.y_m, 0, T_start_robot.yaw_rad, 0, 0);
        write_object(file_, pose);
    }

    void close() { file_.close(); }

  private:
    GzOutputFile file_;
    std::string label_;
};

}  // namespace

RecordingCounts write_recording(ImageSequence& sequence, const RecordingOptions& options) {
    PendingFile pending(options.output);
    Recording recording(pending.path(), options.camera_label);
    FieldSplitter splitter(options.interlaced);
    RecordingCounts counts;
    const auto write_fields = [&](const std::vector<Field>& fields) {
        for (const Field& field : fields) recording.write(field);
        counts.fields += fields.size();
    };
    while (const auto frame = sequence.next()) {
        ++counts.frames;
        write_fields(splitter.push(frame->field));
        if (frame->T_start_robot) {
            recording.write(frame->field.timestamp_s, *frame->T_start_robot);
            ++counts.poses;
        }
        const auto size = static_cast<double>(sequence.size());
        const double share = size > 0 ? static_cast<double>(counts.frames) / size : 0.0;
        if (options.progress) options.progress(share, counts.fields);
    }
    if (counts.frames == 0) {
        const auto& problems = sequence.problems();
        throw InputError("no image could be read" + (problems.empty() ? "" : ": " + problems.front()));
    }
    write_fields(splitter.finish());
    recording.close();
    if (options.progress) options.progress(1.0, counts.fields);
    pending.complete();
    return counts;
}

}  // namespace flownav
