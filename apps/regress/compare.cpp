#include "commands.h"
#include "usage_error.h"

namespace flownav::regress {

int run_compare(const Options& /*options*/, std::ostream& /*out*/) {
    throw UsageError("compare is not there yet");
}

}  // namespace flownav::regress
