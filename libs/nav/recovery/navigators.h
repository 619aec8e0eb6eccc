#pragma once

#include "flownav/nav/make_navigator.h"

namespace flownav::nav {

std::unique_ptr<Navigator> make_lane_navigator(const NavigatorOptions& options);
std::unique_ptr<Navigator> make_reactive_navigator(const NavigatorOptions& options);

}  // namespace flownav::nav
