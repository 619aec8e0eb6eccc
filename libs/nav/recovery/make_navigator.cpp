#include "flownav/nav/make_navigator.h"

#include "navigators.h"

namespace flownav::nav {

std::unique_ptr<Navigator> make_navigator(const NavigatorOptions& options) {
    return options.kind == NavigatorKind::Lanes ? make_lane_navigator(options)
                                                : make_reactive_navigator(options);
}

}  // namespace flownav::nav
