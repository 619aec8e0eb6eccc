#pragma once
#include "flownav/config/config.h"
#include "flownav/pipeline/pipeline.h"

namespace flownav::config {

/// The matcher that `flow.matcher` names.
flow::Matcher make_matcher(const pipeline::Params& params);

/// The pipeline of a configuration, with that matcher.
pipeline::State make_state(const Config& config);

}  // namespace flownav::config
