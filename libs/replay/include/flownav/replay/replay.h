#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "flownav/cli/exit_status.h"
#include "flownav/cli/progress.h"
#include "flownav/config/config.h"
#include "flownav/replay/outputs.h"

namespace flownav::replay {

struct ReplayOptions {
    std::filesystem::path input;   ///< a rawlog
    std::filesystem::path output;  ///< folder, created when it is missing; its output files are overwritten
    config::Config config;
    OptionalOutputs optional;
    bool strict = false;            ///< every warning makes the status Input
    bool timing_in_report = false;  ///< true makes report.html differ between runs
    cli::Progress::Style progress = cli::Progress::Style::Silent;  ///< written to the standard output
};

struct ReplayResult {
    cli::ExitStatus status = cli::ExitStatus::Fine;
    std::string message;                ///< problem, place and advice; empty when there is none
    std::vector<std::string> warnings;  ///< sentences of evaluation::judge()
    std::string outcome;                ///< summary in one line; empty when no file was written
};

/// Runs the complete sensing chain over a rawlog and writes the files of share/doc/outputs.md. Reports bad
/// input and full disks in the result; does not throw on them.
ReplayResult replay(const ReplayOptions& options);

}  // namespace flownav::replay
