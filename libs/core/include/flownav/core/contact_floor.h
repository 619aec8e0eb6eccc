#pragma once
#include <Eigen/Geometry>

#include "flownav/core/contact_scan.h"
#include "flownav/math/grid2d.h"

// What a contact scan says about the floor: strip by strip, at a place, and in the cells of a grid.
namespace flownav {

enum class FloorSight {
    NotSeen,      ///< outside the view, behind an obstacle, or not looked at
    Unconfirmed,  ///< in view of the scan, and not confirmed as floor
    Confirmed,
};

/// Forward distances from the camera between which most scans see what stands on the floor: where one sees
/// neither that nor floor, nothing is likely to stand.
constexpr double looked_through_from_m = 0.9;
constexpr double looked_through_to_m = 2.0;

inline bool is_looked_through(double forward_m) {
    return forward_m >= looked_through_from_m && forward_m < looked_through_to_m;
}

/// Forward distance up to which strip `i` was seen: that of the nearest obstacle of the strip and its two
/// neighbours, at the near end of the obstacle's interval. Infinity when there is none.
double seen_to_m(const ContactScan& scan, int i);

/// Forward distance up to which the floor of strip `i` is confirmed and nothing stands before it; 0 when none
/// is, as in every strip that is Unknown.
double floor_to_m(const ContactScan& scan, int i);

/// What the scan says about the floor of a place whose middle lies `forward_m` ahead of the camera and
/// `right_m` to its right, in the robot frame of the SCAN, and that reaches `half_m` farther ahead. It is
/// Confirmed when it is floor up to its far end. Unconfirmed is told of middles up to the forward distance
/// `unconfirmed_to_m` only: farther away a scan confirms floor by chance.
FloorSight floor_at(const ContactScan& scan, double forward_m, double right_m, double half_m,
                    double unconfirmed_to_m);

/// Share of the strips that show floor, of those that were seen and hold no obstacle: how surely this scan
/// confirms floor of this kind. 0 when no strip was seen.
double floor_share(const ContactScan& scan);

/// Box in a frame around the floor that floor_at() tells about. T_frame_robot: robot frame of the record.
/// Empty when it tells about none.
Eigen::AlignedBox2d floor_bounds(const ContactScan& scan, const Pose2& T_frame_robot,
                                 double unconfirmed_to_m);

/// Calls visit(cell, sight, forward distance from the camera) for every cell of `frame` that is Unconfirmed
/// or Confirmed.
template <class Visit>
void for_each_floor_cell(const ContactScan& scan, const Pose2& T_frame_robot, const GridFrame& frame,
                         double unconfirmed_to_m, const Visit& visit) {
    const Eigen::AlignedBox2d bounds = floor_bounds(scan, T_frame_robot, unconfirmed_to_m);
    if (bounds.isEmpty()) return;
    const Pose2 T_scan_frame = inverse(compose(T_frame_robot, scan.T_robot_scan));
    const Eigen::Vector2d origin_m = transform(T_scan_frame, frame.middle_of({0, 0})) - scan.camera_m;
    const Eigen::Vector2d along_x =
        transform(T_scan_frame, frame.middle_of({1, 0})) - scan.camera_m - origin_m;
    const Eigen::Vector2d along_y(-along_x.y(), along_x.x());
    const Eigen::Vector2i low = frame.cell_of(bounds.min());
    const Eigen::Vector2i high = frame.cell_of(bounds.max());
    for (int y = low.y(); y <= high.y(); ++y) {
        for (int x = low.x(); x <= high.x(); ++x) {
            const Eigen::Vector2d p_m = origin_m + x * along_x + y * along_y;
            const FloorSight sight = floor_at(scan, p_m.x(), -p_m.y(), frame.cell_m / 2, unconfirmed_to_m);
            if (sight != FloorSight::NotSeen) visit(Eigen::Vector2i(x, y), sight, p_m.x());
        }
    }
}

/// The line on the floor at which the obstacle of a strip begins, in the robot frame of the RECORD: from its
/// left end over the middle of the strip to its right end.
struct ContactLine {
    Eigen::Vector2d left_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d right_m = Eigen::Vector2d::Zero();
};

/// The line of strip `i`, which must be an obstacle, as wide as the strip: at its best estimate, of a drop at
/// the near end of its interval. Where a neighbour goes on at a similar range with the same wall or drop, the
/// line ends half-way to the neighbour's middle, so that the lines join.
ContactLine line_of(const ContactScan& scan, int i);

}  // namespace flownav
