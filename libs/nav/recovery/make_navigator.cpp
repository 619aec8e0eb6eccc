#include "flownav/nav/make_navigator.h"

#include <stdexcept>

#include "flownav/core/registry.h"
#include "navigators.h"

namespace flownav::nav {
namespace {

Registry<NavigatorFactory>& navigators() {
    static Registry<NavigatorFactory> all(
        "navigator", {{"lanes", make_lane_navigator}, {"reactive", make_reactive_navigator}});
    return all;
}

}  // namespace

void register_navigator(const std::string& name, NavigatorFactory factory) {
    if (!factory) throw std::invalid_argument("register_navigator: '" + name + "' has no factory");
    navigators().add(name, std::move(factory));
}

std::unique_ptr<Navigator> make_navigator(const std::string& name, const NavigatorOptions& options) {
    return navigators().find(name)(options);
}

std::vector<std::string> navigator_names() {
    return navigators().names();
}

}  // namespace flownav::nav
