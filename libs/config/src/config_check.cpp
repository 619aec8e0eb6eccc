#include <sstream>

#include "flownav/config/config.h"
#include "flownav/math/footprint.h"

namespace flownav::config {
namespace {

constexpr double cells_max = 2000.0;    // along the edge of the local map
constexpr double around_robot_m = 0.4;  // strip of the local map around the robot

/// Throws ConfigError when the value of the first key is above that of the second.
void require_in_order(const char* key, double value, const char* upper_key, double upper) {
    if (value <= upper) return;
    std::ostringstream text;
    text << key << " = " << value << ": is more than " << upper_key << "; allowed: up to " << upper;
    throw ConfigError(text.str());
}

void check_occupancy(const mapping::OccupancyLimits& limits) {
    require_in_order("map.obstacle_below", limits.obstacle_below, "map.doubtful_below",
                     limits.doubtful_below);
    require_in_order("map.plan_certain_below", limits.plan_certain_below, "map.plan_obstacle_below",
                     limits.plan_obstacle_below);
}

}  // namespace

void check_contacts(const Config& config) {
    const obstacles::ContactParams& contacts = config.pipeline.obstacles.contacts;
    require_in_order("obstacles.contact_min_m", contacts.range_min_m, "obstacles.contact_max_m",
                     contacts.range_max_m);
    require_in_order("obstacles.contact_votes", contacts.score_min, "obstacles.contact_votes_sure",
                     contacts.score_sure);
}

void check_map(const Config& config) {
    const mapping::MapParams& map = config.map;
    check_occupancy(map.occupancy);
    if (map.size_m <= cells_max * map.resolution_m) return;
    std::ostringstream text;
    text << "map.size_m = " << map.size_m << ": with map.resolution_m = " << map.resolution_m << " these are "
         << map.size_m / map.resolution_m << " cells across; allowed: up to " << cells_max
         << ", that is map.size_m <= " << cells_max * map.resolution_m;
    throw ConfigError(text.str());
}

void check_navigation(const Config& config) {
    require_in_order("guard.probe_wait_s", config.guard.probe_wait_s, "guard.probe_max_s",
                     config.guard.probe_max_s);
    const double radius_m = circumscribed_radius_m(config.navigation.robot.footprint_m);
    const double least_m = 2.0 * (radius_m + around_robot_m);
    if (config.map.size_m > least_m) return;
    std::ostringstream text;
    text << "map.size_m = " << config.map.size_m
         << ": too small for navigation.footprint_m, whose corners are " << radius_m
         << " m from the axis; allowed: more than " << least_m << " m";
    throw ConfigError(text.str());
}

}  // namespace flownav::config
