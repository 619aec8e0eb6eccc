#pragma once

namespace flownav::mapping {

/// Limits that divide the cells of a map, as probabilities of being FREE; 0.5 is unknown and lies between all
/// "below" and all "above" limits. The users have limits of their own: the guard takes a cell for an obstacle
/// sooner than a local navigator, and the planner sooner still, for it only has to find another way.
struct OccupancyLimits {
    // Local navigators (lanes, reactive).
    double obstacle_below = 0.3;   ///< a cell that must not be touched
    double doubtful_below = 0.47;  ///< a cell that may be an obstacle; lanes over it are worth less
    double seen_above = 0.53;      ///< ground that was seen to be free
    // Guard.
    double guard_obstacle_below = 0.4;
    double guard_free_above = 0.55;
    // Planner and recovery.
    double plan_obstacle_below = 0.45;
    double plan_certain_below = 0.12;  ///< an obstacle that was seen again and again
    double backing_free_above = 0.52;  ///< ground that the robot may back over
    // map.pgm and the counts of its cells.
    double export_occupied_below = 0.35;
    double export_free_above = 0.65;
};

}  // namespace flownav::mapping
