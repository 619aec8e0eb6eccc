#include "flownav/config/make_state.h"

#include "flownav/flow/lk_matcher.h"

namespace flownav {

Matcher make_matcher(const pipeline::Params& params) {
    if (params.flow.matcher == MatcherKind::Sad) return BlockMatcher(params.flow, params.threads);
    LkSettings settings;
    settings.brightness = params.flow.brightness;
    return LkMatcher(settings);
}

pipeline::State make_state(const Config& config) {
    return {config.pipeline, make_matcher(config.pipeline)};
}

}  // namespace flownav
