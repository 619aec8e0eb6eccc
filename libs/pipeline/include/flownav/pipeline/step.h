#pragma once
#include <vector>

#include "flownav/core/contact_scan.h"
#include "flownav/core/ego_motion.h"
#include "flownav/core/field_status.h"
#include "flownav/core/flow_vector.h"
#include "flownav/core/obstacle_point.h"
#include "flownav/core/pose2.h"
#include "flownav/core/sensor_agreement.h"
#include "flownav/core/virtual_scan.h"

namespace flownav::pipeline {

/// Everything that is known about one block after one field.
struct BlockRecord {
    FlowVector vector;                                       ///< last valid measurement of this cycle
    Eigen::Vector2d predicted_px = Eigen::Vector2d::Zero();  ///< flow the prediction expected there (ground)
    RayFlow ray;                                             ///< `vector` on the normalised plane
    int image_of_cycle = 0;                                  ///< image j the vector was measured in; 0: none
    BlockLabel label = BlockLabel::Unplaced;
    bool in_ground_window = false;
    bool fresh = false;      ///< measured in THIS field
    double omega_rad = 0.0;  ///< Eq. (4) of this vector
    double excess_px = 0.0;  ///< left side of Eq. (13) minus expectation, in pixels along e
};

/// How many blocks got how far in this field.
struct BlockCounts {
    int placed = 0;         ///< the search window was (partly) inside the image
    int confident = 0;      ///< passed sifting
    int inliers = 0;        ///< support omega
    int ground_window = 0;  ///< support T
    int ground = 0;
    int obstacle = 0;
    int eliminated = 0;
    int unsupported = 0;
    int moving = 0;
};

/// How much of a pose is not measured but carried over from the last measured motion.
struct CarriedPose {
    double since_s = 0.0;    ///< since turn and speed were both known last, by the flow or by other sensors
    double sigma_m = 0.0;    ///< standard deviation of the position that all carrying since the start caused
    double sigma_rad = 0.0;  ///< the same of the heading
};

/// The record of one field: every intermediate product of field -> flow -> ego-motion -> obstacles.
struct Step {
    double timestamp_s = 0.0;
    FieldStatus status = FieldStatus::Waiting;
    FieldFault fault = FieldFault::None;  ///< of a BadField
    FieldFaultCounts faults{};            ///< of all fields since the start
    bool restarted = false;               ///< a gap, a change of camera or a loss began a new chain here
    int image_of_cycle = 0;               ///< j: 0 for a reference without predecessor, else 1..r
    int cycle_images = 0;                 ///< r, as planned for this cycle
    bool end_of_cycle = false;            ///< obstacles, ground patches and scan are new
    double omega_radps = 0.0;             ///< from the previous field to this one, > 0 left
    double pitch_rate_radps = 0.0;        ///< from the previous field to this one, > 0 raises the view
    double v_mps = 0.0;                   ///< mean forward speed since the reference
    /// A cycle ended here and measured it, or other sensors told it: motion.forward_source; false: predicted
    /// or carried over.
    bool v_measured = false;
    double pitch_correction_rad = 0.0;  ///< added to the pitch of the field's camera (pitch_online)
    EgoMotion motion;                   ///< from the cycle's reference to this field
    Pose2 T_start_robot;                ///< flow odometry; identity at the first field
    CarriedPose carried;                ///< how far T_start_robot can be relied on
    /// Of T_start_robot: x, y (m), yaw (rad) in the start frame, with all that was carried over.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    SensorChecks other_sensors;  ///< how wheels and gyro agree with the flow
    BlockCounts counts;
    std::vector<BlockRecord> blocks;
    std::vector<ObstaclePoint> obstacles;  ///< robot frame at timestamp_s; only at the end of a cycle
    std::vector<GroundPatch> ground;       ///< robot frame at timestamp_s; only at the end of a cycle
    VirtualScan scan;                      ///< only at the end of a cycle
    bool new_contacts = false;             ///< `contacts` were made with this field
    ContactScan contacts;                  ///< the last scan, as seen at the last end of a cycle
};

}  // namespace flownav::pipeline
