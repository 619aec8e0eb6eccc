#include "flownav/config/make_state.h"

#include "flownav/flow/lk_matcher.h"

namespace flownav::config {

flow::Matcher make_matcher(const pipeline::Params& params) {
    if (params.flow.matcher == flow::MatcherKind::Sad) return flow::BlockMatcher(params.flow, params.threads);
    flow::LkSettings settings;
    settings.brightness = params.flow.brightness;
    return flow::LkMatcher(settings);
}

pipeline::State make_state(const Config& config) {
    return {config.pipeline, make_matcher(config.pipeline)};
}

}  // namespace flownav::config
