#pragma once
#include <filesystem>
#include <string>

namespace flownav::testing {

/// Writes the fields of a rawlog as a lossless video, and their camera as an ini, to `folder`. Fields of
/// alternating parity, the top one first, are woven into frames. Returns the lines of a grabber.ini that
/// reads it.
std::string make_drive_video(const std::string& rawlog, const std::filesystem::path& folder);

}  // namespace flownav::testing
