#include "flownav/testing/truth.h"

#include <cmath>

namespace flownav::testing {

EgoMotion exact_motion(const Pose2& from, const Pose2& to) {
    const Pose2 T_from_to = compose(inverse(from), to);
    EgoMotion motion;
    motion.omega_rad = T_from_to.yaw_rad;
    motion.forward_m =
        T_from_to.x_m * std::cos(T_from_to.yaw_rad / 2) + T_from_to.y_m * std::sin(T_from_to.yaw_rad / 2);
    motion.omega_measured = motion.forward_measured = true;
    return motion;
}

EgoMotion exact_motion(const View& from, const View& to) {
    EgoMotion motion = exact_motion(from.T_world_robot, to.T_world_robot);
    motion.pitch_rad = from.camera.mount.pitch_rad - to.camera.mount.pitch_rad;
    return motion;
}

}  // namespace flownav::testing
