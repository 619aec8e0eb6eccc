#include "flownav/io/event_maker.h"

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/system/datetime.h>

#include <cmath>

#include "camera_image.h"
#include "flownav/io/camera_conversion.h"
#include "grey_image.h"
#include "turned_image.h"

namespace flownav::io {
namespace {

using mrpt::obs::CObservation;
using mrpt::obs::CObservationImage;
using mrpt::obs::CObservationIMU;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CObservationRobotPose;

double seconds(const CObservation& observation) {
    const bool valid = observation.timestamp != INVALID_TIMESTAMP;
    return valid ? mrpt::Clock::toDouble(observation.timestamp) : std::nan("");
}

bool finite(const mrpt::math::TPose3D& p) {
    return std::isfinite(p.x + p.y + p.z + p.yaw + p.pitch + p.roll);
}

PoseSample sample_of(const CObservationOdometry& odometry) {
    return {PoseSample::Source::Odometry, seconds(odometry),
            mrpt::math::TPose3D(odometry.odometry.asTPose())};
}

PoseSample sample_of(const CObservationRobotPose& truth) {
    const auto pose_map_robot = truth.pose.mean + (-truth.sensorPose);
    return {PoseSample::Source::GroundTruth, seconds(truth), pose_map_robot.asTPose()};
}

/// Turn rate about the robot's upward axis.
GyroRate rate_of(const CObservationIMU& imu) {
    const auto rate_radps = [&imu](mrpt::obs::TIMUDataIndex index) {
        return imu.has(index) ? imu.get(index) : 0.0;
    };
    const auto& R = imu.sensorPose.getRotationMatrix();
    return {seconds(imu), R(2, 0) * rate_radps(mrpt::obs::IMU_WX) + R(2, 1) * rate_radps(mrpt::obs::IMU_WY) +
                              R(2, 2) * rate_radps(mrpt::obs::IMU_WZ)};
}

/// Text of counts such as "a (3), b (1)".
std::string listed(const std::map<std::string, std::uint64_t>& counts) {
    std::string text;
    for (const auto& [name, count] : counts) {
        text += (text.empty() ? "" : ", ") + name + " (" + std::to_string(count) + ')';
    }
    return text;
}

}  // namespace

std::string why_no_field(const InputCounts& counts, const std::string& source,
                         const std::string& camera_label) {
    const std::string message = "no field could be used in " + source + ": ";
    if (counts.images > 0) return message + "all images were rejected: " + listed(counts.rejected);
    if (counts.observations.empty()) return message + "it holds no observation";
    return message + "it has no image labelled " + camera_label + " but " + listed(counts.observations) +
           "; set camera.camera_label";
}

std::optional<SensorEvent> EventMaker::next() {
    if (waiting_.empty()) return std::nullopt;
    const SensorEvent event = waiting_.front();
    waiting_.pop_front();
    if (std::holds_alternative<Field>(event)) ++counts_.fields;
    return event;
}

void EventMaker::consume(const CObservation::Ptr& observation,
                         const std::filesystem::path& images_directory) {
    const std::string& label = observation->sensorLabel;
    const std::string class_name = observation->GetRuntimeClass()->className;
    ++counts_.observations[class_name.substr(class_name.rfind(':') + 1) + " " + label];
    const auto image = label == camera_.camera_label ? camera_image(observation) : nullptr;
    const auto odometry = std::dynamic_pointer_cast<CObservationOdometry>(observation);
    const auto truth = std::dynamic_pointer_cast<CObservationRobotPose>(observation);
    if (image) {
        consume_image(image, images_directory);
    } else if (odometry && label == input_.odometry_label) {
        consume_pose(sample_of(*odometry));
    } else if (truth && label == input_.truth_label) {
        consume_pose(sample_of(*truth));
    } else if (is_gyro(*observation)) {
        consume_gyro(rate_of(dynamic_cast<const CObservationIMU&>(*observation)));
    } else {
        ++counts_.ignored;
    }
    drain();
}

void EventMaker::finish() {
    times_.finish(counts_);
    drain();
    hand_out(splitter_.finish());
}

/// Hands out the events whose times are decided.
void EventMaker::drain() {
    while (const auto event = times_.pop()) {
        if (const auto* field = std::get_if<Field>(&*event)) {
            note_changes(field->camera);
            hand_out(splitter_.push(*field));
            continue;
        }
        if (const auto* pose = std::get_if<PoseSample>(&*event))
            ++(pose->source == PoseSample::Source::Odometry ? counts_.odometry : counts_.ground_truth);
        if (std::holds_alternative<GyroRate>(*event)) ++counts_.gyro;
        waiting_.push_back(*event);
    }
}

void EventMaker::consume_pose(PoseSample sample) {
    const bool wheels = sample.source == PoseSample::Source::Odometry;
    if (!finite(sample.pose)) {
        ++counts_.rejected[wheels ? "odometry_not_finite" : "ground_truth_not_finite"];
        return;
    }
    if (wheels) sample.timestamp_s += input_.odometry_offset_s;
    times_.push(sample, counts_);
}

/// True for a turn rate of the first gyro.
bool EventMaker::is_gyro(const CObservation& observation) {
    const auto* imu = dynamic_cast<const CObservationIMU*>(&observation);
    if (imu == nullptr || !imu->has(mrpt::obs::IMU_WZ)) return false;
    if (!gyro_label_) gyro_label_ = imu->sensorLabel;
    return *gyro_label_ == imu->sensorLabel;
}

void EventMaker::consume_gyro(const GyroRate& reading) {
    if (!std::isfinite(reading.omega_radps)) {
        ++counts_.rejected["gyro_not_finite"];
        return;
    }
    times_.push(reading, counts_);
}

void EventMaker::consume_image(const CObservationImage::Ptr& image,
                               const std::filesystem::path& images_directory) {
    ++counts_.images;
    const GreyImage grey = grey_image(image, images_directory);
    const bool woven = camera_.interlaced != config::Interlaced::None;
    std::string reason = grey.rejected;
    if (reason.empty() && woven && grey.view.height_px < 2) reason = "image_empty";
    if (!reason.empty()) {
        ++counts_.rejected[reason];
        return;
    }
    Field frame;
    frame.timestamp_s = seconds(*image);
    const CameraReading reading = read_camera(*image, camera_, grey.view.width_px, grey.view.height_px);
    frame.camera = reading.camera;
    if (frame.timestamp_s == std::floor(frame.timestamp_s)) ++counts_.details["images_at_whole_seconds"];
    for (const std::string& note : reading.notes) ++counts_.warnings[note];
    const GreyImage used = turned(grey, camera_);
    frame.image = used.view;
    frame.owner = used.owner;
    times_.push(frame, counts_);
}

void EventMaker::hand_out(const std::vector<Field>& fields) {
    waiting_.insert(waiting_.end(), fields.begin(), fields.end());
}

void EventMaker::note_changes(const CameraModel& now) {
    if (last_camera_ &&
        (last_camera_->width_px != now.width_px || last_camera_->height_px != now.height_px)) {
        ++counts_.warnings["image_size_changed"];
    } else if (last_camera_ && !same_geometry(*last_camera_, now)) {
        ++counts_.warnings["calibration_changed"];
    }
    last_camera_ = now;
}

}  // namespace flownav::io
