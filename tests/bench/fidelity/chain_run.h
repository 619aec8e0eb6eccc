#pragma once
#include <functional>

#include "flownav/config/config.h"
#include "flownav/pipeline/pipeline.h"
#include "rendered_scene.h"

namespace flownav::fidelity {

/// One image of a drive with the result of the chain.
struct Moment {
    const RenderedScene& drive;
    const config::Config& config;
    const pipeline::Step& step;
    int image;      ///< index into drive.fields
    int reference;  ///< index of the image it was compared with; its own index when there was none
};

using Watcher = std::function<void(const Moment& moment)>;

/// Runs the chain over a drive. The chain's camera is that of the fields, changed by the values set in
/// config.camera.
void run_chain(const RenderedScene& drive, const config::Config& config, const Watcher& watcher);

}  // namespace flownav::fidelity
