// Points and floor are moved to the end of a cycle by the motion of the odometry, also at the start of a
// turn, when the robot's chord does not point along half the turn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drives.h"
#include "flownav/math/units.h"
#include "flownav/obstacles/points.h"

namespace flownav {
namespace {

using pipeline::Step;

constexpr double image_s = 0.04;

/// Straight on until image 8, then a turn rate that grows by 20 deg/s per image; > 0 to the left.
std::vector<Field> into_a_turn(double side) {
    testing::DriveOptions options;
    options.images = 14;
    testing::Scene scene = testing::drive(options);
    for (int i = 1; i < options.images; ++i) {
        const double omega_degps = side * std::clamp(20.0 * (i - 8), 0.0, 60.0);
        const auto k = static_cast<std::size_t>(i);
        scene.poses[k] =
            compose(scene.poses[k - 1], along_arc(omega_degps * degree_rad * image_s, 0.6 * image_s));
    }
    return render_fields(scene);
}

/// Distance of a patch to the nearest ground patch computed from the blocks of its cycle.
double off_m(const GroundPatch& patch, const Step& step, const CameraModel& camera,
             const Pose2& T_end_reference) {
    const RayMapper mapper(camera);
    double least_m = std::numeric_limits<double>::infinity();
    for (const pipeline::BlockRecord& block : step.blocks) {
        if (block.label != BlockLabel::Ground) continue;
        const auto expected = obstacles::ground_patch(block.vector.at_px, mapper, T_end_reference, 100.0);
        if (expected) least_m = std::min(least_m, (expected->near_m - patch.near_m).norm());
    }
    return least_m;
}

void expect_floor_where_the_odometry_says(double side) {
    const std::vector<Field> fields = into_a_turn(side);
    const auto steps = testing::run(fields, testing::cycles_of(4));
    double chord_rad = 0.0;
    std::size_t patches = 0;
    std::size_t reference = 0;
    for (std::size_t i = 1; i < steps.size(); ++i) {
        if (!steps[i].end_of_cycle) continue;
        const Pose2 T_end_reference =
            compose(inverse(steps[i].T_start_robot), steps[reference].T_start_robot);
        for (const GroundPatch& patch : steps[i].ground)
            EXPECT_LT(off_m(patch, steps[i], fields[i].camera, T_end_reference), 1e-9);
        patches += steps[i].ground.size();
        chord_rad =
            std::abs(chord_rad) > std::abs(steps[i].motion.chord_rad) ? chord_rad : steps[i].motion.chord_rad;
        reference = i;
    }
    EXPECT_GT(patches, 60U);
    EXPECT_LT(side * chord_rad, -0.005) << "the chord lags behind a turn that begins";
}

TEST(ChordOfPoints, TheFloorLiesWhereTheOdometrySaysInALeftTurn) {
    expect_floor_where_the_odometry_says(1.0);
}

TEST(ChordOfPoints, TheFloorLiesWhereTheOdometrySaysInARightTurn) {
    expect_floor_where_the_odometry_says(-1.0);
}

TEST(ChordOfPoints, HalfWayLiesOnTheWay) {
    EgoMotion motion;
    motion.forward_m = 0.1;
    motion.omega_rad = 0.2;
    motion.chord_rad = -0.05;
    EXPECT_NEAR(pose_after(motion).y_m, 0.1 * std::sin(0.1 - 0.05), 1e-12);
    EXPECT_NEAR(pose_half_way(motion).y_m, 0.05 * std::sin(0.05 - 0.05), 1e-12);
    EXPECT_NEAR(pose_half_way(motion).yaw_rad, 0.1, 1e-12);
}

/// A vector that was not used has zero flow on the normalised plane, not the flow of an earlier field.
TEST(BlockRecord, ASiftedVectorLeavesNoRay) {
    const auto steps = testing::run(into_a_turn(1.0), testing::cycles_of(4));
    int sifted = 0;
    for (const Step& step : steps) {
        for (const pipeline::BlockRecord& block : step.blocks) {
            if (block.label != BlockLabel::Sifted) continue;
            ++sifted;
            EXPECT_EQ(block.ray.flow.norm(), 0.0);
            EXPECT_EQ(block.ray.at.norm(), 0.0);
        }
    }
    EXPECT_GT(sifted, 0);
}

}  // namespace
}  // namespace flownav
