#include "flownav/config/make_state.h"

#include "flownav/flow/lk_matcher.h"
#include "flownav/flow/matcher_registry.h"

namespace flownav::config {

flow::Matcher make_matcher(const pipeline::Params& params) {
    flow::register_lk_matcher();
    return flow::make_matcher(params.flow.matcher, params.flow, params.threads);
}

pipeline::State make_state(const Config& config) {
    return {config.pipeline, make_matcher(config.pipeline)};
}

}  // namespace flownav::config
