#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace flownav::config {

/// Levenshtein's distance, blind to upper and lower case.
std::size_t edit_distance(const std::string& a, const std::string& b);

/// The name of `known` that `name` was most likely meant to be; the first on ties. `known` is not empty.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace flownav::config
