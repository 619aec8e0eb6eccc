#pragma once
#include "flownav/flow/kernel.h"

namespace flownav {

/// The reference kernel: plain C++ that every compiler can vectorise.
BlockMatch match_portable(const std::uint8_t* block, std::ptrdiff_t block_stride, const std::uint8_t* window,
                          std::ptrdiff_t window_stride, const SearchRange& range);

}  // namespace flownav
