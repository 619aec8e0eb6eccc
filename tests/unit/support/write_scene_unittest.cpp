#include "flownav/testing/write_scene.h"

#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "flownav/math/units.h"
#include "temporary_folder.h"

namespace flownav::testing {
namespace {

using mrpt::obs::CObservation;

Scene small_scene(int images = 4, SceneKind kind = SceneKind::SCurve) {
    SceneOptions options;
    options.kind = kind;
    options.images = images;
    options.camera = standard_camera(64, 96);
    options.camera.mount.forward_m = 0.1;
    options.interlaced = true;
    return make_scene(options);
}

std::vector<CObservation::Ptr> read(const std::filesystem::path& file) {
    mrpt::io::CFileGZInputStream in(file.string());
    auto archive = mrpt::serialization::archiveFrom(in);
    std::vector<CObservation::Ptr> observations;
    try {
        for (;;) observations.push_back(archive.ReadObject<CObservation>());
    } catch (const mrpt::serialization::CExceptionEOF&) {
    }
    return observations;
}

TEST(WriteScene, RawlogHoldsOdometryTruthAndImageOfEveryMoment) {
    const TemporaryFolder folder;
    const Scene scene = small_scene();
    write_scene(scene, folder / "s");
    const auto observations = read(folder / "s.rawlog");
    ASSERT_EQ(observations.size(), 12U);
    for (std::size_t i = 0; i < observations.size(); ++i) {
        const std::vector<std::string> labels = {"ODOMETRY", "GROUND_TRUTH", "CAMERA1"};
        EXPECT_EQ(observations[i]->sensorLabel, labels[i % 3]);
        const std::size_t image = i / 3;
        EXPECT_NEAR(mrpt::Clock::toDouble(observations[i]->timestamp),
                    1767225600.0 + 0.04 * static_cast<double>(image), 1e-6);
    }
    const auto truth = std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(observations[10]);
    ASSERT_TRUE(truth);
    EXPECT_DOUBLE_EQ(truth->pose.mean.x(), scene.poses[3].x_m);
    EXPECT_NEAR(truth->pose.mean.yaw(), scene.poses[3].yaw_rad, 1e-12);
}

TEST(WriteScene, ImageCarriesItsPixelsAndItsCalibration) {
    const TemporaryFolder folder;
    const Scene scene = small_scene();
    write_scene(scene, folder / "s");
    const auto image = std::dynamic_pointer_cast<mrpt::obs::CObservationImage>(read(folder / "s.rawlog")[5]);
    ASSERT_TRUE(image);
    const CameraModel camera = nominal_view(scene, 1).camera;
    EXPECT_EQ(image->cameraParams.nrows, 48U);
    EXPECT_DOUBLE_EQ(image->cameraParams.fy(), camera.fy_px);
    EXPECT_DOUBLE_EQ(image->cameraParams.cy(), camera.cy_px);
    const GreyImage rendered = render_image(scene, 1);
    for (const int v : {0, 20, 47})
        EXPECT_EQ(*image->image.ptr<std::uint8_t>(33, static_cast<unsigned>(v)), rendered.at(33, v));
}

TEST(WriteScene, CameraPoseLooksAheadAndDownFromAboveTheGround) {
    const TemporaryFolder folder;
    const Scene scene = small_scene();
    write_scene(scene, folder / "s");
    const auto image = std::dynamic_pointer_cast<mrpt::obs::CObservationImage>(read(folder / "s.rawlog")[2]);
    ASSERT_TRUE(image);
    EXPECT_NEAR(image->cameraPose.yaw(), -M_PI / 2, 1e-9);
    EXPECT_NEAR(image->cameraPose.roll(), -(90.0 + 25.0) * degree_rad, 1e-9);
}

TEST(WriteScene, CameraPosePutsPointsWhereTheRendererProjectsThem) {
    const TemporaryFolder folder;
    Scene scene = small_scene();
    CameraMount& mount = scene.options.camera.mount;
    mount.roll_rad = 0.05;
    mount.yaw_rad = -0.08;
    mount.left_m = 0.07;
    write_scene(scene, folder / "s");
    const auto image = std::dynamic_pointer_cast<mrpt::obs::CObservationImage>(read(folder / "s.rawlog")[2]);
    ASSERT_TRUE(image);
    const CameraModel camera = nominal_view(scene, 0).camera;
    for (const Eigen::Vector2d& ray : {Eigen::Vector2d(0.0, 0.0), {0.3, 0.1}, {-0.2, 0.25}}) {
        const mrpt::math::TPoint3D p = image->cameraPose.composePoint({2 * ray.x(), 2 * ray.y(), 2.0});
        const auto pixel = project(nominal_view(scene, 0), {p.x, p.y, p.z});
        ASSERT_TRUE(pixel);
        EXPECT_NEAR(pixel->x(), camera.cx_px + camera.fx_px * ray.x(), 1e-6);
        EXPECT_NEAR(pixel->y(), camera.cy_px + camera.fy_px * ray.y(), 1e-6);
    }
}

TEST(WriteScene, OdometryIsTruthWithScaleAndSmallErrors) {
    SceneOptions options;
    options.images = 500;
    const Scene scene = make_scene(options);
    const std::vector<Pose2> odometry = make_odometry(scene);
    ASSERT_EQ(odometry.size(), scene.poses.size());
    double ratio = 0.0;
    for (std::size_t i = 1; i < odometry.size(); ++i) {
        ratio += exact_motion(odometry[i - 1], odometry[i]).forward_m /
                 exact_motion(scene.poses[i - 1], scene.poses[i]).forward_m /
                 static_cast<double>(odometry.size() - 1);
    }
    EXPECT_NEAR(ratio, 1.006, 0.002);
}

TEST(WriteScene, TablesHaveTheAgreedColumns) {
    const TemporaryFolder folder;
    const Scene scene = small_scene();
    write_scene(scene, folder / "s");
    std::istringstream truth(bytes_of(folder / "s.gt.csv"));
    std::string line;
    std::getline(truth, line);
    EXPECT_EQ(line, "i,t,x,y,phi,omega_radps,v_mps");
    std::getline(truth, line);
    EXPECT_EQ(line, "0,0.0000,0.0000000,0.0000000,0.0000000,nan,nan");
    std::istringstream objects(bytes_of(folder / "s.objects.csv"));
    std::getline(objects, line);
    EXPECT_EQ(
        line,
        "type(0,\"box,1\",cylinder),cx,cy,z0,z1,half_x_or_radius,half_y,cos_yaw,sin_yaw,texture,shade,group");
    std::size_t rows = 0;
    while (std::getline(objects, line)) {
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), 11);
        ++rows;
    }
    EXPECT_EQ(rows, scene.world.solids.size());
    EXPECT_FALSE(std::filesystem::exists(folder / "s.movers.csv"));
}

TEST(WriteScene, MoverHasItsPositionPerImage) {
    const TemporaryFolder folder;
    write_scene(small_scene(4, SceneKind::Mover), folder / "m");
    std::istringstream movers(bytes_of(folder / "m.movers.csv"));
    std::string line;
    for (int i = 0; i < 3; ++i) std::getline(movers, line);
    EXPECT_EQ(line, "1.9660000,1.2900000");
}

TEST(WriteScene, SameSceneGivesTheSameBytes) {
    const TemporaryFolder folder;
    write_scene(small_scene(), folder / "a");
    write_scene(small_scene(), folder / "b");
    EXPECT_EQ(bytes_of(folder / "a.rawlog"), bytes_of(folder / "b.rawlog"));
    EXPECT_FALSE(bytes_of(folder / "a.rawlog").empty());
}

TEST(WriteScene, UnwritableFolderIsNamed) {
    const TemporaryFolder folder;
    try {
        write_scene(small_scene(), folder / "absent" / "s");
        FAIL();
    } catch (const std::runtime_error& e) {
        EXPECT_NE(std::string(e.what()).find("absent"), std::string::npos);
    }
}

}  // namespace
}  // namespace flownav::testing
