#pragma once
#include <cstdint>
#include <optional>

#include "flownav/replay/replay.h"

namespace flownav::replay {

struct RealtimeOptions {
    std::filesystem::path input;   ///< a rawlog
    std::filesystem::path output;  ///< folder for realtime.json; empty: nothing is written
    config::Config config;
    std::optional<double> duration_s;                ///< empty: the recording once
    std::uint64_t memory_max_bytes = 2'000'000'000;  ///< of the fields, which are held decoded
};

/// Plays the fields of a rawlog at their time stamps, as a camera delivers them, and measures how long each
/// takes from its arrival until the navigator's input, the local map, is ready. The result's outcome holds
/// the figures. Never throws on bad input or full disks.
ReplayResult replay_realtime(const RealtimeOptions& options);

}  // namespace flownav::replay
