#pragma once
#include <functional>
#include <string>

#include "flownav/flow/kernel.h"

namespace flownav::bench {

// Each function registers its benchmarks; main() runs them.
void register_kernels();
void register_flow_comparison();
void register_steps();
void register_growth();
void register_replays();

/// Calls `enter` for every kernel of the table that this processor supports.
void for_each_kernel(const std::function<void(const flow::KernelEntry&)>& enter);

/// Names of the kernels of the table that are supported or not, separated by spaces.
std::string kernel_names(bool supported);

}  // namespace flownav::bench
