#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "flownav/regress/runner.h"
#include "flownav/regress/shard.h"

namespace flownav::regress {

/// Parsed command line of flownav-regress; each command uses the options that it accepts.
struct Options {
    std::string command;
    std::vector<std::filesystem::path> folders;  ///< positional arguments: DIR, or DIR_A DIR_B
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

/// Parses the arguments; empty when they have been answered, with the exit status in `status`. Throws
/// UsageError.
std::optional<Options> parse_options(const std::vector<std::string>& arguments,
                                     const Environment& environment, std::ostream& out, std::ostream& error,
                                     int& status);

}  // namespace flownav::regress
