#include <sstream>

#include "flownav/config/config.h"
#include "flownav/math/footprint.h"

namespace flownav::config {
namespace {

constexpr double cells_max = 2000.0;    // along the edge of the local map
constexpr double around_robot_m = 0.4;  // strip of the local map around the robot

void check_guard(const nav::GuardParams& guard) {
    if (guard.probe_wait_s <= guard.probe_max_s) return;
    std::ostringstream text;
    text << "guard.probe_wait_s = " << guard.probe_wait_s
         << ": is more than guard.probe_max_s; allowed: up to " << guard.probe_max_s;
    throw ConfigError(text.str());
}

}  // namespace

void check_map(const Config& config) {
    const mapping::MapParams& map = config.map;
    if (map.size_m <= cells_max * map.resolution_m) return;
    std::ostringstream text;
    text << "map.size_m = " << map.size_m << ": with map.resolution_m = " << map.resolution_m << " these are "
         << map.size_m / map.resolution_m << " cells across; allowed: up to " << cells_max
         << ", that is map.size_m <= " << cells_max * map.resolution_m;
    throw ConfigError(text.str());
}

void check_navigation(const Config& config) {
    check_guard(config.guard);
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
