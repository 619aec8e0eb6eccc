#include "flownav/evaluation/trajectory_file.h"

#include <mrpt/math/CQuaternion.h>
#include <mrpt/poses/CPose3D.h>

#include "flownav/cli/number_text.h"

namespace flownav::evaluation {

namespace {

constexpr int position_decimals = 6;
constexpr int rotation_decimals = 9;

}  // namespace

void TrajectoryFile::write(double timestamp_s, const mrpt::math::TPose3D& pose) {
    mrpt::math::CQuaternionDouble q;
    mrpt::poses::CPose3D(pose).getAsQuaternion(q);
    std::string line = cli::time_text(timestamp_s);
    for (const double coordinate : {pose.x, pose.y, pose.z})
        line += ' ' + cli::fixed_text(coordinate, position_decimals);
    for (const double part : {q.x(), q.y(), q.z(), q.r()})
        line += ' ' + cli::fixed_text(part, rotation_decimals);
    file_.write(line + '\n');
}

void TrajectoryFile::write(double timestamp_s, const Pose2& pose) {
    write(timestamp_s, mrpt::math::TPose3D(pose.x_m, pose.y_m, 0.0, pose.yaw_rad, 0.0, 0.0));
}

}  // namespace flownav::evaluation
