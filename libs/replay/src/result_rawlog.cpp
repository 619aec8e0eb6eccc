#include "flownav/replay/result_rawlog.h"

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>

#include <opencv2/core/mat.hpp>

#include "flownav/sensor/camera_conversion.h"
#include "flownav/sensor/observations.h"

namespace flownav {
namespace {

mrpt::img::CImage pixels(const ImageView& view) {
    // OpenCV has no view of constant pixels; the copy below only reads.
    const cv::Mat source(view.height_px, view.width_px, CV_8UC1, const_cast<std::uint8_t*>(view.data),
                         static_cast<std::size_t>(view.stride_bytes));
    return {source.clone(), mrpt::img::SHALLOW_COPY};
}

}  // namespace

void ResultRawlog::write(const pipeline::Step& step) {
    write_object(*odometry_observation(step));
    if (!step.end_of_cycle) return;
    write_object(*scan_observation(step, range_max_m_));
    write_object(*points_observation(step));
}

void ResultRawlog::write_odometry(const PoseSample& sample) {
    mrpt::obs::CObservationOdometry odometry;
    odometry.timestamp = mrpt::Clock::fromDouble(sample.timestamp_s);
    odometry.sensorLabel = "ODOMETRY";
    odometry.odometry = mrpt::poses::CPose2D(mrpt::math::TPose2D(sample.pose));
    write_object(odometry);
}

void ResultRawlog::write_image(const Field& field, const std::string& label) {
    mrpt::obs::CObservationImage image;
    image.timestamp = mrpt::Clock::fromDouble(field.timestamp_s);
    image.sensorLabel = label;
    image.cameraPose = camera_pose(field.camera.mount);
    image.cameraParams = camera_params(field.camera);
    image.image = pixels(field.image);
    write_object(image);
}

void ResultRawlog::write_object(const mrpt::obs::CObservation& observation) {
    mrpt::serialization::archiveFrom(file_) << observation;
    ++counts_[observation.sensorLabel];
}

}  // namespace flownav
