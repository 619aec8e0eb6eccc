#pragma once

#include <string>
#include <vector>

#include "flownav/regress/expectation.h"

namespace flownav::regress {

/// The outcome of check() in the XML of JUnit, as CI servers read it: a test case a rawlog, with a failure
/// that lists what is out of tolerance.
std::string junit_xml(const std::string& suite, const RunResults& results,
                      const std::vector<Deviation>& deviations);

}  // namespace flownav::regress
