#include "ride.h"

#include <Eigen/Core>

#include "flownav/sim/ground.h"

namespace flownav::testing {

using Eigen::Vector2d;

Ride ride_over(const sim::World& world, const Pose2& T_world_robot) {
    constexpr double half_wheelbase_m = 0.20;
    constexpr double half_track_m = 0.20;
    constexpr double unsprung = 0.2;  // share of the floor's slope that reaches the body
    const auto axle_m = [&](double forward_m) {
        return 0.5 * (ground_height_m(world, transform(T_world_robot, Vector2d(forward_m, half_track_m))) +
                      ground_height_m(world, transform(T_world_robot, Vector2d(forward_m, -half_track_m))));
    };
    const double front_m = axle_m(half_wheelbase_m);
    const double rear_m = axle_m(-half_wheelbase_m);
    return {0.5 * (front_m + rear_m), -unsprung * (front_m - rear_m) / (2.0 * half_wheelbase_m)};
}

}  // namespace flownav::testing
