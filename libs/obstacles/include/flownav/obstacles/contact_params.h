#pragma once

namespace flownav::obstacles {

/// The contact scan looks for upright surfaces that stand on the floor, at every bearing.
struct ContactParams {
    bool on = true;
    double travel_m = 0.12;       ///< the robot travels at least so far between the two images of a scan
    double range_min_m = 0.7;     ///< nearest contact
    double range_max_m = 3.6;     ///< farthest contact
    double score_min = 15.0;      ///< votes of a contact that was seen in an earlier scan as well
    double score_sure = 30.0;     ///< votes of a contact that a single scan confirms
    double fit_share_min = 0.45;  ///< of the near floor; with less the scan says nothing
};

}  // namespace flownav::obstacles
