#pragma once
#include <array>
#include <string_view>

namespace flownav::config {

/// An earlier name of a key, and the present one; both are "section.key".
struct RenamedKey {
    std::string_view earlier;
    std::string_view present;
};

/// An earlier word of a key, and the present one. `key` is the key's present name.
struct RenamedWord {
    std::string_view key;
    std::string_view earlier;
    std::string_view present;
};

/// The earlier names that are still read, with a warning. A key is renamed by one line here and its name in
/// the table of keys.
inline constexpr std::array renamed_keys = {
    RenamedKey{"flow.blind_cone", "flow.focus_exclusion"},
    RenamedKey{"navigation.plan", "navigation.replan"},
    RenamedKey{"navigation.decide_every_s", "navigation.controller_period_s"},
};

inline constexpr std::array renamed_words = {
    RenamedWord{"navigation.replan", "stuck", "when_stuck"},
};

}  // namespace flownav::config
