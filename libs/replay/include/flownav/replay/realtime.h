#pragma once
#include <cstdint>
#include <optional>

#include "flownav/replay/replay.h"

namespace flownav::replay {

struct RealtimeOptions {
    std::filesystem::path input;   ///< a rawlog
    std::filesystem::path output;  ///< folder for realtime.json; empty: no file is written
    config::Config config;
    std::optional<double> duration_s;                ///< empty: plays the recording once
    std::uint64_t memory_max_bytes = 2'000'000'000;  ///< limit of the decoded fields
};

/// Plays the fields of a rawlog at their time stamps, as a camera delivers them, and measures the latency
/// from the arrival of each until the local map, the navigator's input, is ready. The result's outcome holds
/// the figures. Reports bad input and full disks in the result; does not throw on them.
ReplayResult replay_realtime(const RealtimeOptions& options);

}  // namespace flownav::replay
