#pragma once
#include "flownav/pipeline/pipeline.h"
#include "flownav/sensor/config.h"

namespace flownav {

/// The matcher that `flow.matcher` names.
Matcher make_matcher(const pipeline::Params& params);

/// The pipeline of a configuration, with that matcher.
pipeline::State make_state(const Config& config);

}  // namespace flownav
