#pragma once
#include <functional>
#include <string>
#include <vector>

#include "flownav/flow/matcher.h"
#include "flownav/flow/params.h"

namespace flownav::flow {

/// Makes a matcher for the settings; the results must not depend on the number of threads.
using MatcherFactory = std::function<Matcher(const FlowParams& params, int threads)>;

/// Adds a matcher, which `flow.matcher = name` then selects. "sad" is built in. Call it before the
/// configuration is read. Throws std::invalid_argument: no factory, or a name that is taken or holds other
/// characters than a-z, 0-9 and _.
void register_matcher(const std::string& name, MatcherFactory factory);

/// Makes the matcher of a name. Throws std::invalid_argument, which lists the known names.
Matcher make_matcher(const std::string& name, const FlowParams& params, int threads = 1);

/// Names of all matchers, in the order of their registration.
std::vector<std::string> matcher_names();

}  // namespace flownav::flow
