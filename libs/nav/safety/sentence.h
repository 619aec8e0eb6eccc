#pragma once

#include <iomanip>
#include <sstream>
#include <string>

namespace flownav::nav {

/// Words and numbers (two decimals) one after the other.
template <typename... Parts>
std::string sentence(const Parts&... parts) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2);
    (text << ... << parts);
    return text.str();
}

}  // namespace flownav::nav
