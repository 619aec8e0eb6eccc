#pragma once
#include <cstdint>
#include <vector>

namespace flownav::io {

/// Compresses bytes into one complete member of a gz file. A sequence of members is a gz file with the
/// contents in that order, so a file that grows by whole members is always complete. `level`: 0 (stored) to 9
/// (smallest), or the default of zlib. The header holds no time: the same bytes give the same member.
constexpr int gz_default_level = -1;
std::vector<std::uint8_t> gz_member(const std::vector<std::uint8_t>& bytes, int level = gz_default_level);

}  // namespace flownav::io
