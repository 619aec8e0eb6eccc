#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "flownav/core/pose2.h"
#include "flownav/core/virtual_scan.h"

namespace flownav {

/// Why a cycle has no contact scan.
enum class ContactGate {
    Open,       ///< the cycle was scanned
    Off,        ///< switched off, or no cycle has ended yet
    NoTravel,   ///< the travel is neither measured nor told by the wheels, or too short
    PoorFloor,  ///< too few pixels of the near floor move as a floor does: mirror, wrong camera pose
};

/// All gates, in the order of ContactGate.
constexpr std::array<ContactGate, 4> all_contact_gates = {ContactGate::Open, ContactGate::Off,
                                                          ContactGate::NoTravel, ContactGate::PoorFloor};

/// Name of a gate, as written to files.
const char* to_string(ContactGate gate);

/// Registration of the floor between the two images of a scan: corrections to the measured motion that make
/// the floor fit best. They serve the scan only, not the odometry.
struct FloorFit {
    double forward_m = 0.0;       ///< added to the travel
    double omega_rad = 0.0;       ///< added to the turn
    double pitch_rad = 0.0;       ///< added to the pitch between the images
    double roll_rad = 0.0;        ///< roll between the images
    double tilt_pitch_rad = 0.0;  ///< slope of the floor along the heading
    double tilt_roll_rad = 0.0;   ///< slope of the floor across the heading
    double fit_share = 0.0;       ///< of the informative pixels of the near floor: those that fit
    double vignetting = 0.0;      ///< learnt fall-off of brightness at the corner of the image
};

/// Content of one strip of bearings. All distances are FORWARD distances from the camera along the heading.
struct ContactStrip {
    BeamKind kind = BeamKind::Unknown;
    BeamCause cause = BeamCause::None;  ///< of an obstacle
    double free_m = 0.0;     ///< floor is confirmed from the lower border of the view up to here; 0: none
    double contact_m = 0.0;  ///< an obstacle stands on the floor here, or the floor ends; only of an obstacle
    double near_m = 0.0;     ///< the contact lies between near_m
    double far_m = 0.0;      ///< and far_m
    double score = 0.0;      ///< sum of votes for the contact
    bool seen = false;  ///< in view with an edge in it, and the gate open: what is not free was looked at
};

/// What stands on the floor, and where the floor is confirmed, strip by strip. Strip i covers the tangents
/// (first + i) * step to (first + i + 1) * step of the angle to the RIGHT of the heading, seen from the
/// camera.
struct ContactScan {
    ContactGate gate = ContactGate::Off;
    int first = 0;
    double step = 0.05;
    double view_near_m = 0.5;  ///< forward distance of the lower border of the view: not seen nearer
    Eigen::Vector2d camera_m = Eigen::Vector2d::Zero();  ///< robot frame: (forward, left)
    Pose2 T_robot_scan;  ///< robot frame of the scan (end of its cycle) in the robot frame of the record
    FloorFit floor;
    std::vector<ContactStrip> strips;
};

/// Tangent of the angle to the right at the middle of strip `i`.
inline double middle_tangent(const ContactScan& scan, int i) {
    return (scan.first + i + 0.5) * scan.step;
}

/// Point of tangent `right` at the forward distance `forward_m` from the camera, in the robot frame of the
/// RECORD.
inline Eigen::Vector2d point_of(const ContactScan& scan, double right, double forward_m) {
    return transform(scan.T_robot_scan,
                     {scan.camera_m.x() + forward_m, scan.camera_m.y() - right * forward_m});
}

}  // namespace flownav
