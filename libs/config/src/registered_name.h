#pragma once
#include <algorithm>

#include "config_key.h"
#include "flownav/core/registry.h"

namespace flownav::config {

/// Throws BadValue, which lists the known names, when `name` is none of them.
inline void require_known(const std::string& name, const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), name) == known.end())
        throw BadValue("is none of the known names (" + listed(known) + ")");
}

/// A name of a registry, whose `names` are asked at every reading. The documented range lists the names that
/// are registered when the table of keys is used first.
template <class Place>
Key registered_name(const Doc& doc, std::vector<std::string> (*names)(), Place place) {
    return make_key(
        doc, listed(names()), [=](const Config& config) -> std::string { return place(config); },
        [=](Config& config, const std::string& name) {
            require_known(name, names());
            place(config) = name;
        });
}

}  // namespace flownav::config
