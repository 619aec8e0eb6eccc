#pragma once
#include <functional>
#include <string>

#include "flownav/flow/kernel.h"

namespace flownav::bench {

// Each enters its benchmarks; main() runs them.
void register_kernels();
void register_flow_comparison();
void register_steps();
void register_growth();
void register_replays();

/// Calls `enter` for every kernel of the table that this processor runs.
void for_each_kernel(const std::function<void(const flow::KernelEntry&)>& enter);

/// Names of the kernels of the table, supported or not, with a space between them.
std::string kernel_names(bool supported);

}  // namespace flownav::bench
