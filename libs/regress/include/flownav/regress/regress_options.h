#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "flownav/regress/runner.h"
#include "flownav/regress/shard.h"

namespace flownav::regress {

/// What flownav-regress was asked for; each command uses what it accepts.
struct Options {
    std::string command;
    std::vector<std::filesystem::path> folders;  ///< what stands alone: DIR, or DIR_A DIR_B
    std::filesystem::path manifest, root, output;
    std::optional<Shard> shard;
    std::string config, program;
    std::vector<std::string> settings;
    RunOptions run;
    std::filesystem::path expected, junit;
    bool any_version = false;
    bool missing = false, failed = false;
    bool quiet = false;
};

/// What the arguments ask for, or nothing when they have been answered; then `status` says how. Throws
/// UsageError.
std::optional<Options> parse_options(const std::vector<std::string>& arguments,
                                     const Environment& environment, std::ostream& out, std::ostream& error,
                                     int& status);

}  // namespace flownav::regress
