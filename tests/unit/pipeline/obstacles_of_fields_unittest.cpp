#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drives.h"
#include "flownav/math/units.h"

namespace flownav {
namespace {

using pipeline::Step;
using testing::cycles_of;
using testing::DriveOptions;

/// Distance of a point of the ground plan to the nearest outline of an object whose lower end is at most
/// `z_low_m` above the floor.
double distance_to_surface_m(const sim::World& world, const Eigen::Vector2d& point_m,
                             double z_low_m = std::numeric_limits<double>::max()) {
    double nearest_m = std::numeric_limits<double>::max();
    for (const sim::Solid& solid : world.solids)
        if (testing::upright_of(solid).z_low_m <= z_low_m)
            nearest_m = std::min(nearest_m, testing::distance_m(solid, point_m));
    return nearest_m;
}

TEST(ObstaclesOfFields, PointsLieOnTheSurfacesOfTheScene) {
    DriveOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = 13;
    options.omega_degps = 10.0;  // points not moved to the end of the cycle would miss their surface
    const testing::Scene scene = testing::drive(options);
    const auto steps = testing::run(render_fields(scene), cycles_of(6));
    int points = 0, on_surface = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        for (const ObstaclePoint& p : steps[i].obstacles) {
            const Eigen::Vector2d at = transform(scene.poses[i], p.position_m.head<2>());
            ++points;
            on_surface += distance_to_surface_m(scene.world, at) < std::max(0.1, 2 * p.sigma_m);
        }
    }
    EXPECT_GT(points, 30);
    EXPECT_GT(on_surface, 0.9 * points);
}

TEST(ObstaclesOfFields, FreeFloorHasNoneAndItsFloorIsConfirmed) {
    DriveOptions options;
    options.images = 13;
    options.omega_degps = 20.0;
    int points = 0;
    for (const Step& step : testing::run(render_fields(testing::drive(options)), cycles_of(4))) {
        points += static_cast<int>(step.obstacles.size());
        if (!step.end_of_cycle || !step.v_measured) continue;
        EXPECT_GT(step.ground.size(), 20U);
        const Beam& ahead = step.scan.beams.at(step.scan.beams.size() / 2);
        EXPECT_EQ(ahead.kind, BeamKind::Free);
        EXPECT_GT(ahead.range_m, 1.0);
    }
    EXPECT_EQ(points, 0);
}

TEST(ObstaclesOfFields, ACrawlingRobotWithAFastCameraSeesTheFloorAhead) {
    DriveOptions options;
    options.images = 52;
    options.v_mps = 0.1;
    options.rate_hz = 50.0;
    double farthest_m = 0.0;
    for (const Step& step : testing::run(render_fields(testing::drive(options)))) {
        for (const GroundPatch& patch : step.ground) farthest_m = std::max(farthest_m, patch.far_m.x());
    }
    EXPECT_GT(farthest_m, 1.3);
}

TEST(ObstaclesOfFields, GroundPatchesLieOnFreeFloor) {
    DriveOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = 9;
    const testing::Scene scene = testing::drive(options);
    const auto steps = testing::run(render_fields(scene), cycles_of(4));
    int patches = 0, on_objects = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        for (const GroundPatch& p : steps[i].ground) {
            ++patches;
            const Eigen::Vector2d at = transform(scene.poses[i], p.near_m);
            on_objects += distance_to_surface_m(scene.world, at, 0.05) <= 0.0;
        }
    }
    EXPECT_GT(patches, 30);
    EXPECT_LE(on_objects, patches / 50);
}

TEST(ObstaclesOfFields, PureRotationYieldsNone) {
    DriveOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = 9;
    options.v_mps = 0.0;
    options.omega_degps = 10.0;
    const auto steps = testing::run(render_fields(testing::drive(options)), cycles_of(4));
    for (const Step& step : steps) EXPECT_TRUE(step.obstacles.empty()) << step.obstacles.size();
    EXPECT_NEAR(deg(steps.back().omega_radps), 10.0, 0.3);
    EXPECT_NEAR(steps.back().v_mps, 0.0, 0.01);
}

TEST(ObstaclesOfFields, RobotAtRestYieldsNone) {
    DriveOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = 9;
    options.v_mps = 0.0;
    for (const Step& step : testing::run(render_fields(testing::drive(options)), cycles_of(4)))
        EXPECT_TRUE(step.obstacles.empty()) << step.obstacles.size();
}

}  // namespace
}  // namespace flownav
