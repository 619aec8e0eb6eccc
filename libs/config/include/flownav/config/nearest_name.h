#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace flownav::config {

/// Levenshtein distance; upper and lower case are the same.
std::size_t edit_distance(const std::string& a, const std::string& b);

/// The name of `known` with the least edit distance to `name`; the first on ties. `known` must not be empty.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace flownav::config
