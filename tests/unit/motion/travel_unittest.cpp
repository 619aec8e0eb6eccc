#include "travel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/sim/random.h"
#include "flownav/testing/camera.h"

namespace flownav::motion {
namespace {

using Eigen::Vector2d;

/// Motion of a robot between two images; the chord points along half the turn.
struct Motion {
    double forward_m = 0.0;
    double omega_rad = 0.0;
};

/// A camera above a floor by plain trigonometry, independent of the code under test.
class Floor {
  public:
    explicit Floor(const CameraModel& camera = testing::standard_camera()) : camera_(camera) {}

    /// Point of the floor (forward, left) that a pixel shows; only for pixels below the horizon.
    Vector2d shown_by(const Vector2d& pixel_px) const {
        const double x = (pixel_px.x() - camera_.cx_px) / camera_.fx_px;
        const double down_rad =
            camera_.mount.pitch_rad + std::atan((pixel_px.y() - camera_.cy_px) / camera_.fy_px);
        const double forward_m = camera_.mount.height_m / std::tan(down_rad);
        return {forward_m, -x * depth_m(forward_m)};
    }
    /// Normalised coordinates of a point of the floor.
    Vector2d seen_at(const Vector2d& floor_m) const {
        const double down_m = camera_.mount.height_m * std::cos(camera_.mount.pitch_rad) -
                              floor_m.x() * std::sin(camera_.mount.pitch_rad);
        return Vector2d(-floor_m.y(), down_m) / depth_m(floor_m.x());
    }
    MotionSample sample(const Vector2d& pixel_px, const Motion& motion) const {
        const Vector2d before_m = shown_by(pixel_px);
        const Vector2d moved_m = before_m - motion.forward_m * Vector2d(std::cos(motion.omega_rad / 2),
                                                                        std::sin(motion.omega_rad / 2));
        const double c = std::cos(motion.omega_rad);
        const double s = std::sin(motion.omega_rad);
        const Vector2d begin = seen_at(before_m);
        const Vector2d end = seen_at({c * moved_m.x() + s * moved_m.y(), c * moved_m.y() - s * moved_m.x()});
        MotionSample sample;
        sample.ray = {(begin + end) / 2, end - begin, Vector2d::Constant(0.3 / camera_.fx_px)};
        sample.in_ground_window = pixel_px.y() > camera_.height_px * 2.0 / 3 &&
                                  std::abs(pixel_px.x() - camera_.width_px / 2.0) < camera_.width_px / 3.0;
        return sample;
    }
    /// Samples over the lower two thirds of the image.
    std::vector<MotionSample> samples(const Motion& motion) const {
        constexpr int step_px = 30;
        std::vector<MotionSample> all;
        for (int v = camera_.height_px / 3; v < camera_.height_px; v += step_px) {
            for (int u = step_px / 2; u < camera_.width_px; u += step_px)
                all.push_back(sample({u, v}, motion));
        }
        return all;
    }
    const CameraModel& camera() const { return camera_; }

  private:
    double depth_m(double forward_m) const {
        return forward_m * std::cos(camera_.mount.pitch_rad) +
               camera_.mount.height_m * std::sin(camera_.mount.pitch_rad);
    }

    CameraModel camera_;
};

Travel travel_of(const std::vector<MotionSample>& samples, double omega_rad = 0.0) {
    Rotation rotation;
    rotation.turn.omega_rad = omega_rad;
    MotionScratch scratch;
    return fit_travel(samples, Floor().camera(), {1.0, 0.0}, rotation, {}, scratch);
}

/// At most `count` of the samples inside or outside the ground window.
std::vector<MotionSample> some(const std::vector<MotionSample>& samples, bool in_window, std::size_t count) {
    std::vector<MotionSample> chosen;
    for (const MotionSample& s : samples) {
        if (s.in_ground_window == in_window && chosen.size() < count) chosen.push_back(s);
    }
    return chosen;
}

/// Samples of the near floor beside the ground window.
std::vector<MotionSample> beside_window(const Motion& motion, std::size_t count) {
    std::vector<MotionSample> samples;
    const Floor floor;
    samples.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        samples.push_back(
            floor.sample({i % 2 == 0 ? 40.0 : 600.0, 350.0 + 4.0 * static_cast<double>(i)}, motion));
    }
    return samples;
}

TEST(FitTravel, ForwardIsPositiveAndBackwardNegativeOnStraightsAndInTurns) {
    for (const double forward_m : {0.064, -0.064, 0.01, -0.01}) {
        for (const double omega_rad : {0.0, 0.08, -0.08}) {
            const Travel travel = travel_of(Floor().samples({forward_m, omega_rad}), omega_rad);
            EXPECT_NEAR(travel.along_m, forward_m, 0.003 * std::abs(forward_m)) << omega_rad;
            EXPECT_GT(travel.support, 60);
        }
    }
}

TEST(FitTravel, OfARobotThatStandsItIsZeroAndMeasured) {
    const Travel travel = travel_of(Floor().samples({}));
    EXPECT_EQ(travel.along_m, 0.0);
    EXPECT_GT(travel.support, 60);
}

TEST(FitTravel, ThingsThatStandOnTheFloorDoNotMoveIt) {
    for (const double forward_m : {0.064, -0.064}) {
        std::vector<MotionSample> samples = Floor().samples({forward_m, 0.0});
        sim::HashRandom random(21);
        int wild = 0;
        for (MotionSample& s : samples) {
            if (random.uniform(0, 1) > 0.35) continue;
            s.ray.flow *= random.uniform(1.3, 3.0);  // nearer than the floor
            ++wild;
        }
        const Travel travel = travel_of(samples);
        EXPECT_NEAR(travel.along_m, forward_m, 0.01 * std::abs(forward_m));
        EXPECT_LE(travel.support, static_cast<int>(samples.size()) - wild / 2);
    }
}

TEST(FitTravel, VectorsAcrossTheirLineThroughTheFocusDoNotCount) {
    std::vector<MotionSample> samples = Floor().samples({0.064, 0.0});
    for (MotionSample& s : samples) s.ray.flow = {-s.ray.flow.y(), s.ray.flow.x()};
    const Travel travel = travel_of(samples);
    EXPECT_EQ(travel.support, 0);
    EXPECT_EQ(travel.along_m, 0.0);
}

TEST(FitTravel, WithTooFewVectorsItIsNotMeasured) {
    const std::vector<MotionSample> all = Floor().samples({0.064, 0.0});
    EXPECT_EQ(travel_of({}).support, 0);
    EXPECT_EQ(travel_of(some(all, true, 5)).support, 0);
    EXPECT_EQ(travel_of(some(all, true, 5)).along_m, 0.0);
    EXPECT_EQ(travel_of(some(all, true, 6)).support, 6);
    EXPECT_EQ(travel_of(beside_window({0.064, 0.0}, 11)).support, 0);
    EXPECT_EQ(travel_of(beside_window({0.064, 0.0}, 12)).support, 12);
    EXPECT_NEAR(travel_of(beside_window({-0.064, 0.0}, 12)).along_m, -0.064, 2e-4);
}

TEST(FitTravel, TheFarFloorDoesNotCount) {
    std::vector<MotionSample> far;
    far.reserve(100);
    const Floor floor;
    for (int i = 0; i < 100; ++i) far.push_back(floor.sample({20.0 + 6.0 * i, 110.0 + i % 10}, {0.064, 0.0}));
    EXPECT_EQ(travel_of(far).support, 0);
}

TEST(FitTravel, TheWindowIsBelievedWhereTheRestOfTheFloorSaysSomethingElse) {
    for (const double forward_m : {0.064, -0.064}) {
        std::vector<MotionSample> samples = some(Floor().samples({forward_m, 0.0}), true, 30);
        const std::vector<MotionSample> beside = beside_window({1.3 * forward_m, 0.0}, 32);
        samples.insert(samples.end(), beside.begin(), beside.end());
        EXPECT_NEAR(travel_of(samples).along_m, forward_m, 0.005 * std::abs(forward_m));
    }
}

TEST(FitTravel, WhereTheWindowShowsLittleAllOfTheFloorThatSaysTheSameIsUsed) {
    const std::vector<MotionSample> all = Floor().samples({0.064, 0.0});
    std::vector<MotionSample> samples = some(all, true, 8);
    const double window_sigma_m = travel_of(samples).sigma_m;
    const std::vector<MotionSample> beside = beside_window({0.064, 0.0}, 32);
    samples.insert(samples.end(), beside.begin(), beside.end());
    const Travel travel = travel_of(samples);
    EXPECT_EQ(travel.support, 40);
    EXPECT_LT(travel.sigma_m, 0.8 * window_sigma_m);
}

TEST(FitTravel, ItsDeviationIsThatOfItsErrors) {
    const Floor floor;
    const std::vector<MotionSample> exact = floor.samples({0.064, 0.0});
    sim::HashRandom random(22);
    const double sigma = 0.3 / floor.camera().fx_px;
    double mean2 = 0.0;
    constexpr int runs = 100;
    for (int run = 0; run < runs; ++run) {
        std::vector<MotionSample> noisy = exact;
        for (MotionSample& s : noisy) s.ray.flow += Vector2d(random.normal(sigma), random.normal(sigma));
        const Travel travel = travel_of(noisy);
        mean2 += std::pow((travel.along_m - 0.064) / travel.sigma_m, 2) / runs;
    }
    EXPECT_NEAR(std::sqrt(mean2), 1.0, 0.3);
}

}  // namespace
}  // namespace flownav::motion
