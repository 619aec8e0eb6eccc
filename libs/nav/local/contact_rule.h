#pragma once

#include <algorithm>

namespace flownav::nav {

/// Decides when a footprint touches the middle of an occupied cell. Distances are signed distances to the
/// footprint, < 0 inside: `first_m` where the robot stands now, `distance_m` farther along its way.
///
/// A robot must be able to leave cells that it stands beside or on: they are touched only when it comes
/// nearer to them.
struct ContactRule {
    double margin_m = 0.0;    ///< a cell nearer than this is touched
    double nearer_m = 0.003;  ///< smallest approach that counts; the accuracy of FootprintField
    double under_m = 0.06;    ///< a cell deeper below the robot is an error of the map and is ignored

    bool is_ignored(double first_m) const { return first_m < -under_m; }

    /// Also true when distance_m is NaN.
    bool touches(double first_m, double distance_m) const {
        return !(distance_m >= margin_m) && !(distance_m >= first_m - nearer_m) && !is_ignored(first_m);
    }

    /// The rule with a margin that keeps the nearest cell out of it, but with at least `least_m`.
    /// `nearest_m`: smallest first_m of the cells that are not ignored.
    ContactRule beside(double nearest_m, double least_m = 0.02) const {
        ContactRule rule = *this;
        rule.margin_m = std::min(margin_m, std::max(least_m, nearest_m - nearer_m));
        return rule;
    }
};

}  // namespace flownav::nav
