#pragma once
#include <string>

#include "config_key.h"

namespace flownav::config {

/// The known key with the most similar name, then the most similar section; the first of the table on ties.
const Key& nearest_key(const std::string& section, const std::string& name);

}  // namespace flownav::config
