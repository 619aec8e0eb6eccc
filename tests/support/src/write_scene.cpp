#include "flownav/testing/write_scene.h"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "flownav/sim/random.h"
#include "tables.h"

namespace flownav::testing {
namespace {

using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;

mrpt::Clock::time_point timestamp(const Scene& scene, int i) {
    using Ticks = std::chrono::duration<std::int64_t, std::ratio<1, 10000000>>;
    return mrpt::Clock::fromDouble(scene_start_s) + Ticks(std::llround(scene.time_s(i) * 1e7));
}

double rounded(double value) {
    return std::round(value * 1e7) / 1e7;
}

CPose2D to_mrpt(const Pose2& pose) {
    return {pose.x_m, pose.y_m, pose.yaw_rad};
}

mrpt::obs::CObservationOdometry odometry_of(const Scene& scene, const std::vector<Pose2>& odometry, int i) {
    const auto k = static_cast<std::size_t>(i);
    mrpt::obs::CObservationOdometry o;
    o.sensorLabel = "ODOMETRY";
    o.timestamp = timestamp(scene, i);
    o.odometry = to_mrpt(odometry[k]);
    if (i == 0) return o;
    const EgoMotion motion = exact_motion(odometry[k - 1], odometry[k]);
    o.hasVelocities = true;
    o.velocityLocal.vx = rounded(motion.forward_m * scene.options.rate_hz);
    o.velocityLocal.omega = rounded(motion.omega_rad * scene.options.rate_hz);
    return o;
}

mrpt::obs::CObservationRobotPose ground_truth_of(const Scene& scene, int i) {
    mrpt::obs::CObservationRobotPose o;
    o.sensorLabel = "GROUND_TRUTH";
    o.timestamp = timestamp(scene, i);
    o.pose.mean = CPose3D(to_mrpt(scene.poses[static_cast<std::size_t>(i)]));
    return o;
}

/// Where the camera sits and looks: x to the right, y down, z ahead.
CPose3D camera_pose(const CameraMount& m) {
    CPose3D aimed(m.forward_m, m.left_m, m.height_m, m.yaw_rad - M_PI / 2, 0.0, -M_PI / 2 - m.pitch_rad);
    if (m.roll_rad == 0.0) return aimed;
    return aimed + CPose3D(0.0, 0.0, 0.0, m.roll_rad, 0.0, 0.0);
}

mrpt::img::TCamera camera_parameters(const CameraModel& camera) {
    mrpt::img::TCamera c;
    c.ncols = static_cast<std::uint32_t>(camera.width_px);
    c.nrows = static_cast<std::uint32_t>(camera.height_px);
    c.setIntrinsicParamsFromValues(camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px);
    const auto& k = camera.distortion;
    c.setDistortionPlumbBob(k[0], k[1], k[2], k[3], k[4]);
    c.cameraName = "camera1";
    return c;
}

mrpt::img::CImage to_mrpt(const GreyImage& image) {
    mrpt::img::CImage out(image.width_px, image.height_px, mrpt::img::CH_GRAY);
    for (int v = 0; v < image.height_px; ++v) {
        std::memcpy(out.ptrLine<std::uint8_t>(static_cast<unsigned>(v)), image.view().row(v),
                    static_cast<std::size_t>(image.width_px));
    }
    return out;
}

mrpt::obs::CObservationImage image_of(const Scene& scene, int i) {
    const CameraModel camera = nominal_view(scene, i).camera;
    mrpt::obs::CObservationImage o;
    o.sensorLabel = "CAMERA1";
    o.timestamp = timestamp(scene, i);
    o.cameraPose = camera_pose(camera.mount);
    o.cameraParams = camera_parameters(camera);
    o.image = to_mrpt(render_image(scene, i));
    return o;
}

void write_rawlog(const Scene& scene, const std::filesystem::path& file, const WriteOptions& options) {
    mrpt::io::CFileGZOutputStream out;
    if (!out.open(file.string(), options.gz_level))
        throw std::runtime_error(file.string() + ": cannot be written");
    auto archive = mrpt::serialization::archiveFrom(out);
    const std::vector<Pose2> odometry = make_odometry(scene, options.odometry);
    for (int i = 0; i < scene.images(); ++i) {
        archive << odometry_of(scene, odometry, i) << ground_truth_of(scene, i) << image_of(scene, i);
        if (options.progress) options.progress(i + 1, scene.images());
    }
}

}  // namespace

std::vector<Pose2> make_odometry(const Scene& scene, const OdometryErrors& errors) {
    sim::HashRandom random(sim::mix(scene.options.seed, 13));
    std::vector<Pose2> odometry{scene.poses.front()};
    for (std::size_t i = 1; i < scene.poses.size(); ++i) {
        const EgoMotion motion = exact_motion(scene.poses[i - 1], scene.poses[i]);
        const double distance_m = motion.forward_m * errors.scale + random.normal(errors.distance_sigma_m);
        const double turn_rad = motion.omega_rad * errors.yaw_scale + random.normal(errors.yaw_sigma_rad);
        const Pose2 next = compose(odometry.back(), along_arc(turn_rad, distance_m));
        odometry.push_back({rounded(next.x_m), rounded(next.y_m), rounded(next.yaw_rad)});
    }
    return odometry;
}

void write_scene(const Scene& scene, const std::filesystem::path& basename, const WriteOptions& options) {
    write_ground_truth_csv(scene, with_suffix(basename, ".gt.csv"));
    write_objects_csv(scene, with_suffix(basename, ".objects.csv"));
    write_movers_csv(scene, with_suffix(basename, ".movers.csv"));
    write_rawlog(scene, with_suffix(basename, ".rawlog"), options);
}

}  // namespace flownav::testing
