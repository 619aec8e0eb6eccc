#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "flownav/cli/progress.h"
#include "flownav/config/config.h"
#include "flownav/replay/outputs.h"

namespace flownav::replay {

struct ReplayOptions {
    std::filesystem::path input;   ///< a rawlog
    std::filesystem::path output;  ///< folder, made when it is missing; what is in it is overwritten
    config::Config config;
    OptionalOutputs optional;
    bool timing_in_report = false;  ///< then report.html differs from run to run
    cli::Progress::Style progress = cli::Progress::Style::Silent;  ///< on the standard output
};

enum class ExitStatus {
    Fine = 0,
    Usage = 1,   ///< bad usage or configuration; nothing was written
    Input = 2,   ///< the input is damaged or ended early; all that was readable was written
    Output = 3,  ///< output could not be written
};

struct ReplayResult {
    ExitStatus status = ExitStatus::Fine;
    std::string message;                ///< what, where, what to do; empty when all is fine
    std::vector<std::string> warnings;  ///< about results that are less than they seem, and the camera's pose
    std::string outcome;                ///< what was found, in one line; empty when nothing was written
};

/// Runs the complete sensing chain over a rawlog and writes everything that share/doc/outputs.md lists. Never
/// throws on bad input or full disks: the result says what happened.
ReplayResult replay(const ReplayOptions& options);

}  // namespace flownav::replay
