#pragma once
#include <cstdint>
#include <vector>

namespace flownav {

/// The bytes as one complete member of a gz file. Members in a row are a gz file, and its content is theirs
/// in a row; so a file that grows by whole members is complete at any moment. `level` 0 (stored) .. 9
/// (small). The header carries no time: the same bytes give the same member.
std::vector<std::uint8_t> gz_member(const std::vector<std::uint8_t>& bytes, int level);

}  // namespace flownav
