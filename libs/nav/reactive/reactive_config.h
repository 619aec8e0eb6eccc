#pragma once

#include <string>

#include "flownav/nav/make_navigator.h"

namespace flownav::nav {

/// Every corner moved outward so that every edge is `by_m` farther out.
Polygon inflated(const Polygon& polygon, double by_m);

/// The ini that CReactiveNavigationSystem is configured with.
std::string reactive_config(const NavigatorOptions& options);

/// Room that the tables of CReactiveNavigationSystem keep between the footprint and the middle of a cell.
constexpr double reactive_margin_m = 0.08;

/// How far it looks.
constexpr double reactive_range_m = 4.0;

}  // namespace flownav::nav
