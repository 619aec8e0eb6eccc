#include "nearest_key.h"

#include <algorithm>

#include "flownav/config/nearest_name.h"

namespace flownav::config {

const Key& nearest_key(const std::string& section, const std::string& name) {
    // The name decides, the section breaks ties: keys are often given in the wrong section.
    const auto distance = [&](const Key& key) {
        return 4 * edit_distance(name, key.doc.name) +
               std::min<std::size_t>(3, edit_distance(section, key.doc.section));
    };
    const auto& keys = key_table();
    return *std::min_element(keys.begin(), keys.end(),
                             [&](const Key& a, const Key& b) { return distance(a) < distance(b); });
}

}  // namespace flownav::config
