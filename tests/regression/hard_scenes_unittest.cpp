// Scenes outside the laboratory, each a stretch of a preset, with the default configuration.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drives.h"
#include "flownav/math/units.h"
#include "flownav/testing/presets.h"

namespace flownav {
namespace {

using Eigen::Vector2d;
using pipeline::Step;
using testing::Scene;

constexpr int settling = 6;  // images until the chain is under way

/// A stretch of a preset, and what the sensor says of it.
struct Stretch {
    Scene scene;
    int first;
    std::vector<Step> steps;
    std::vector<double> errors_degps;  ///< of the turn rate, an image
    std::vector<double> v_percent;     ///< of the speed, a cycle that measured it

    Stretch(const std::string& preset, int from, int images) : first(from) {
        testing::SceneOptions options = testing::preset(preset, 1).value();
        options.images = std::max(options.images, from + images);
        scene = make_scene(options);
        std::vector<Field> fields;
        for (int i = from; i < from + images; ++i) fields.push_back(make_field(scene, i));
        steps = testing::run(fields);
        for (int i = settling; i < images; ++i) compare(i);
    }
    EgoMotion truth(int i) const {
        const auto k = static_cast<std::size_t>(first + i);
        return testing::exact_motion(scene.poses[k - 1], scene.poses[k]);
    }
    void compare(int i) {
        const Step& step = steps[static_cast<std::size_t>(i)];
        EXPECT_EQ(step.status, FieldStatus::Ok) << "image " << i;
        const double rate_hz = scene.options.rate_hz;
        errors_degps.push_back(deg(step.omega_radps - truth(i).omega_rad * rate_hz));
        if (step.v_measured) v_percent.push_back(100.0 * (step.v_mps / scene.options.speed_mps - 1.0));
    }
    double omega_rms_degps() const {
        double squares = 0.0;
        for (const double e : errors_degps) squares += e * e;
        return std::sqrt(squares / static_cast<double>(errors_degps.size()));
    }
    /// The mean is what heading is made of.
    double omega_mean_degps() const {
        double sum = 0.0;
        for (const double e : errors_degps) sum += e;
        return sum / static_cast<double>(errors_degps.size());
    }
    double v_mean_percent() const {
        double sum = 0.0;
        for (const double e : v_percent) sum += e;
        return sum / static_cast<double>(v_percent.size());
    }
    /// Share of the obstacle points at most 0.15 m + 6 % of their range from something, and how many there
    /// are.
    std::pair<double, int> points_near_surfaces() const {
        int all = 0;
        int near = 0;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const int image = first + static_cast<int>(i);
            const sim::World world = testing::at_time(scene.world, scene.time_s(image));
            for (const ObstaclePoint& point : steps[i].obstacles) {
                const Vector2d p = point.position_m.head<2>();
                const Vector2d at = transform(scene.poses[static_cast<std::size_t>(image)], p);
                double nearest = 1e9;
                for (const auto& solid : world.solids)
                    nearest = std::min(nearest, testing::distance_m(solid, at));
                ++all;
                near += nearest < 0.15 + 0.06 * p.norm();
            }
        }
        return {all > 0 ? static_cast<double>(near) / all : 1.0, all};
    }
};

TEST(HardScenes, AMoverOnMostOfTheBlocksDoesNotTakeTheTurnRate) {
    for (const auto& [preset, from] : {std::pair("mover25", 90), std::pair("mover45", 80)}) {
        const Stretch stretch(preset, from, 50);
        EXPECT_LT(stretch.omega_rms_degps(), 0.1) << preset;
        EXPECT_LT(std::abs(stretch.omega_mean_degps()), 0.02) << preset;
        EXPECT_LT(std::abs(stretch.v_mean_percent()), 0.5) << preset;
        EXPECT_GT(stretch.steps.back().counts.moving, 60) << preset;
    }
}

TEST(HardScenes, AMoverIsReportedWhereItTouchesTheGround) {
    const Stretch stretch("mover45", 80, 40);
    const auto [near, all] = stretch.points_near_surfaces();
    EXPECT_GT(all, 300);
    EXPECT_GT(near, 0.95);
    int moving = 0;
    for (const Step& step : stretch.steps) {
        for (const ObstaclePoint& point : step.obstacles) moving += point.moving;
    }
    EXPECT_GT(moving, 200);
}

TEST(HardScenes, NothingMovesWhereEverythingStands) {
    const Stretch stretch("carpet", 40, 40);
    for (const Step& step : stretch.steps) {
        for (const ObstaclePoint& point : step.obstacles) EXPECT_FALSE(point.moving);
    }
}

TEST(HardScenes, StepsOfTheExposureChangeNothing) {
    const Stretch stretch("exposure-steps", 20, 40);
    EXPECT_LT(stretch.omega_rms_degps(), 0.06);
    EXPECT_LT(std::abs(stretch.v_mean_percent()), 0.3);
    EXPECT_GT(stretch.points_near_surfaces().first, 0.93);
}

TEST(HardScenes, FlickeringLampsChangeNothing) {
    const Stretch stretch("flicker", 20, 40);
    EXPECT_LT(stretch.omega_rms_degps(), 0.06);
    EXPECT_LT(std::abs(stretch.v_mean_percent()), 0.3);
}

TEST(HardScenes, VibrationOfThePitchDoesNotReachTheTurnRate) {
    const Stretch stretch("vibration015", 20, 40);
    EXPECT_LT(stretch.omega_rms_degps(), 0.12);
    EXPECT_LT(std::abs(stretch.omega_mean_degps()), 0.03);
    EXPECT_LT(std::abs(stretch.v_mean_percent()), 0.8);
}

TEST(HardScenes, ACameraAheadOfTheAxisInTurnsOf30DegreesASecond) {
    const Stretch stretch("ahead", 20, 40);
    EXPECT_LT(stretch.omega_rms_degps(), 0.06);
    EXPECT_LT(std::abs(stretch.v_mean_percent()), 0.4);
}

TEST(HardScenes, ATiltedCamera) {
    const Stretch stretch("roll", 20, 30);
    EXPECT_LT(stretch.omega_rms_degps(), 0.06);
    EXPECT_LT(std::abs(stretch.v_mean_percent()), 0.4);
}

TEST(HardScenes, AWideAndDistortingLens) {
    const Stretch stretch("wide", 20, 30);
    EXPECT_LT(stretch.omega_rms_degps(), 0.12);
    EXPECT_LT(std::abs(stretch.v_mean_percent()), 0.4);
}

TEST(HardScenes, OverAPlainFloorTheTurnIsMeasuredAndTheSpeedIsNot) {
    const Stretch stretch("plain", 20, 40);
    EXPECT_LT(stretch.omega_rms_degps(), 0.5);
    EXPECT_LT(std::abs(stretch.omega_mean_degps()), 0.1);
    EXPECT_TRUE(stretch.v_percent.empty());
    EXPECT_EQ(stretch.points_near_surfaces().second, 0);
    for (const Step& step : stretch.steps) {
        for (const Beam& beam : step.scan.beams) EXPECT_EQ(beam.kind, BeamKind::Unknown);
    }
}

TEST(HardScenes, LinoleumHasEnoughTextureForASpeed) {
    const Stretch stretch("lino", 20, 40);
    EXPECT_LT(stretch.omega_rms_degps(), 0.25);
    EXPECT_LT(std::abs(stretch.v_mean_percent()), 1.0);
}

}  // namespace
}  // namespace flownav
