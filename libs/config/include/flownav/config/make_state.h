#pragma once
#include "flownav/config/config.h"
#include "flownav/pipeline/pipeline.h"

namespace flownav::config {

/// Makes the matcher that `flow.matcher` names: a registered one, or "lk" of OpenCV. Throws
/// std::invalid_argument, which lists the known names.
flow::Matcher make_matcher(const pipeline::Params& params);

/// Makes the pipeline of a configuration with that matcher. Throws as make_matcher() does.
pipeline::State make_state(const Config& config);

}  // namespace flownav::config
