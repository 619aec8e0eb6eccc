#pragma once
#include <array>
#include <string>
#include <vector>

namespace flownav::evaluation {

/// Seconds spent in the stages of a replay.
struct StageTimes {
    double decode_s = 0.0;  ///< reading the recording, decoding images
    double match_s = 0.0;   ///< matching blocks
    double motion_s = 0.0;  ///< ego-motion and obstacles
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
    double timestamp_s = 0.0;  ///< time of the field
    StageTimes spent;          ///< time spent since the previous field
};

/// Timing of a replay; may differ between runs.
struct Timing {
    StageTimes stages;  ///< sums over the whole replay
    std::vector<FieldTimes> fields;
    double total_s = 0.0;
    int threads = 1;
    std::string kernel;
};

}  // namespace flownav::evaluation
