#pragma once
#include <functional>

#include "flownav/config/config.h"
#include "flownav/pipeline/pipeline.h"
#include "rendered_scene.h"

namespace flownav::fidelity {

/// One image of a drive after the chain has seen it.
struct Moment {
    const RenderedScene& drive;
    const config::Config& config;
    const pipeline::Step& step;
    int image;      ///< index into drive.fields
    int reference;  ///< the image that it was compared with; itself when it was compared with none
};

using Watcher = std::function<void(const Moment& moment)>;

/// Runs the chain over a drive. The camera that it believes in is that of the fields with what
/// config.camera sets.
void run_chain(const RenderedScene& drive, const config::Config& config, const Watcher& watcher);

}  // namespace flownav::fidelity
