#include "flownav/io/observations.h"

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPose2D.h>

#include <algorithm>
#include <array>
#include <opencv2/core/mat.hpp>

#include "flownav/io/camera_conversion.h"

namespace flownav::io {
namespace {

mrpt::img::CImage pixels(const ImageView& view) {
    // cv::Mat has no const view; the copy below only reads.
    const cv::Mat source(view.height_px, view.width_px, CV_8UC1, const_cast<std::uint8_t*>(view.data),
                         static_cast<std::size_t>(view.stride_bytes));
    return {source.clone(), mrpt::img::SHALLOW_COPY};
}

}  // namespace

mrpt::obs::CObservation2DRangeScan::Ptr scan_observation(const pipeline::Step& step, double range_max_m) {
    auto scan = mrpt::obs::CObservation2DRangeScan::Create();
    const VirtualScan& source = step.scan;
    const std::size_t beams = source.beams.size();
    scan->timestamp = mrpt::Clock::fromDouble(step.timestamp_s);
    scan->sensorLabel = "FLOW_SCAN";
    scan->rightToLeft = true;
    const double aperture_rad = source.step_rad * static_cast<double>(beams > 0 ? beams - 1 : 0);
    scan->aperture = static_cast<float>(aperture_rad);
    scan->maxRange = static_cast<float>(range_max_m);
    const double centre_rad = source.first_bearing_rad + aperture_rad / 2.0;
    scan->sensorPose = mrpt::poses::CPose3D(0, 0, 0, centre_rad, 0, 0);
    scan->resizeScan(beams);
    for (std::size_t i = 0; i < beams; ++i) {
        const Beam& beam = source.beams[i];
        scan->setScanRange(i, beam.kind == BeamKind::Unknown ? 0.0F : static_cast<float>(beam.range_m));
        scan->setScanRangeValidity(i, beam.kind == BeamKind::Obstacle);
    }
    return scan;
}

mrpt::obs::CObservationPointCloud::Ptr points_observation(const pipeline::Step& step) {
    auto points = mrpt::maps::CSimplePointsMap::Create();
    points->reserve(step.obstacles.size());
    for (const ObstaclePoint& point : step.obstacles) {
        const Eigen::Vector3f position = point.position_m.cast<float>();
        points->insertPointFast(position.x(), position.y(), position.z());
    }
    points->mark_as_modified();
    auto cloud = mrpt::obs::CObservationPointCloud::Create();
    cloud->timestamp = mrpt::Clock::fromDouble(step.timestamp_s);
    cloud->sensorLabel = "FLOW_POINTS";
    cloud->pointcloud = points;
    return cloud;
}

mrpt::obs::CObservationOdometry::Ptr odometry_observation(const pipeline::Step& step) {
    auto odometry = mrpt::obs::CObservationOdometry::Create();
    odometry->timestamp = mrpt::Clock::fromDouble(step.timestamp_s);
    odometry->sensorLabel = "FLOW_ODOMETRY";
    const Pose2& pose = step.T_start_robot;
    odometry->odometry = mrpt::poses::CPose2D(pose.x_m, pose.y_m, pose.yaw_rad);
    odometry->hasVelocities = step.status == FieldStatus::Ok || step.motion.omega_measured;
    if (odometry->hasVelocities) odometry->velocityLocal = {step.v_mps, 0.0, step.omega_radps};
    return odometry;
}

mrpt::obs::CObservationRobotPose::Ptr pose_observation(const pipeline::Step& step) {
    constexpr std::array<int, 3> x_y_yaw = {0, 1, 3};  // of MRPT's x, y, z, yaw, pitch, roll
    auto observation = mrpt::obs::CObservationRobotPose::Create();
    observation->timestamp = mrpt::Clock::fromDouble(step.timestamp_s);
    observation->sensorLabel = "FLOW_POSE";
    const Pose2& pose = step.T_start_robot;
    observation->pose.mean = mrpt::poses::CPose3D(pose.x_m, pose.y_m, 0, pose.yaw_rad, 0, 0);
    observation->pose.cov.setZero();
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            observation->pose.cov(x_y_yaw.at(i), x_y_yaw.at(k)) = step.covariance(i, k);
    return observation;
}

mrpt::obs::CObservationOdometry::Ptr odometry_observation(const PoseSample& sample) {
    auto odometry = mrpt::obs::CObservationOdometry::Create();
    odometry->timestamp = mrpt::Clock::fromDouble(sample.timestamp_s);
    odometry->sensorLabel = "ODOMETRY";
    odometry->odometry = mrpt::poses::CPose2D(mrpt::math::TPose2D(sample.pose));
    return odometry;
}

mrpt::obs::CObservationImage::Ptr image_observation(const Field& field, const std::string& label) {
    auto image = mrpt::obs::CObservationImage::Create();
    image->timestamp = mrpt::Clock::fromDouble(field.timestamp_s);
    image->sensorLabel = label;
    image->cameraPose = camera_pose(field.camera.mount);
    image->cameraParams = camera_params(field.camera);
    image->image = pixels(field.image);
    return image;
}

}  // namespace flownav::io
