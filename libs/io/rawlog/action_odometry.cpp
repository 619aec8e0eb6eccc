#include "action_odometry.h"

#include <mrpt/obs/CActionRobotMovement2D.h>

namespace flownav::io {

void ActionOdometry::add(const mrpt::obs::CActionCollection& actions) {
    for (const auto& action : actions) {
        const auto* movement = dynamic_cast<const mrpt::obs::CActionRobotMovement2D*>(&*action);
        if (movement == nullptr) continue;
        using mrpt::obs::CActionRobotMovement2D;
        if (movement->estimationMethod == CActionRobotMovement2D::emOdometry) {
            pose_ = pose_ + movement->rawOdometryIncrementReading;
        } else if (movement->poseChange) {
            pose_ = pose_ + movement->poseChange->getMeanVal();
        }
        timestamp_ = movement->timestamp;
        due_ = true;
        return;  // all movements of one collection are estimates of the same step
    }
}

mrpt::obs::CObservationOdometry::Ptr ActionOdometry::take(const mrpt::obs::CSensoryFrame& frame) {
    if (!due_) return nullptr;
    due_ = false;
    auto reading = mrpt::obs::CObservationOdometry::Create();
    reading->sensorLabel = "ODOMETRY";
    reading->odometry = pose_;
    reading->timestamp = timestamp_;
    for (const auto& observation : frame) {
        if (reading->timestamp != INVALID_TIMESTAMP) break;
        if (observation) reading->timestamp = observation->timestamp;
    }
    return reading;
}

}  // namespace flownav::io
