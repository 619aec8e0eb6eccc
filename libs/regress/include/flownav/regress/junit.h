#pragma once

#include <string>
#include <vector>

#include "flownav/regress/expectation.h"

namespace flownav::regress {

/// The outcome of check() as JUnit XML for CI servers: one test case per rawlog, with a failure that lists
/// the deviations.
std::string junit_xml(const std::string& suite, const RunResults& results,
                      const std::vector<Deviation>& deviations);

}  // namespace flownav::regress
