#include "commands.h"
#include "usage_error.h"

namespace flownav::regress {

int run_sweep(const Options& /*options*/, std::ostream& /*out*/, std::ostream& /*error*/) {
    throw UsageError("sweep is not there yet");
}

}  // namespace flownav::regress
