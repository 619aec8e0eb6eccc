#pragma once
#include <array>
#include <string>
#include <vector>

namespace flownav::evaluation {

/// Seconds spent in the stages of a replay.
struct StageTimes {
    double decode_s = 0.0;  ///< reading the recording, decoding images
    double match_s = 0.0;   ///< finding blocks again
    double motion_s = 0.0;  ///< ego-motion, and what is an obstacle
    double map_s = 0.0;     ///< entering obstacles and floor into the map
    double write_s = 0.0;   ///< files, pictures, report
};

struct NamedStage {
    const char* name;
    double StageTimes::*seconds;
};

constexpr std::array<NamedStage, 5> all_stages = {{{"decode", &StageTimes::decode_s},
                                                   {"match", &StageTimes::match_s},
                                                   {"motion", &StageTimes::motion_s},
                                                   {"map", &StageTimes::map_s},
                                                   {"write", &StageTimes::write_s}}};

struct FieldTimes {
    double timestamp_s = 0.0;  ///< of the field
    StageTimes spent;          ///< since the field before
};

/// Where the time went: all that may differ from run to run.
struct Timing {
    StageTimes stages;  ///< of the whole replay
    std::vector<FieldTimes> fields;
    double total_s = 0.0;
    int threads = 1;
    std::string kernel;
};

}  // namespace flownav::evaluation
