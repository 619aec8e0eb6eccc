#pragma once

#include <ostream>

#include "flownav/cli/usage_error.h"
#include "flownav/regress/regress_options.h"

namespace flownav::regress {

/// The commands of flownav-regress: options to exit status. They throw cli::UsageError, ConfigError and
/// OutputError.
int run_manifest(const Options& options, std::ostream& out);
int run_run(const Options& options, std::ostream& out, std::ostream& error);
int run_merge(const Options& options, std::ostream& out, std::ostream& error);
int run_check(const Options& options, std::ostream& out);
int run_accept(const Options& options, std::ostream& out);
int run_compare(const Options& options, std::ostream& out);
int run_sweep(const Options& options, std::ostream& out, std::ostream& error);

/// Replays `jobs` with progress on `out` and problems on `error`, and prints the result.
RunTally replay_all(const std::vector<Job>& jobs, const Options& options, std::ostream& out,
                    std::ostream& error);

/// Returns the exit status of a run.
int status_of(const RunTally& tally);

/// Writes a file by renaming a complete temporary one. Throws OutputError.
void write_atomically(const std::filesystem::path& file, const std::string& text);

}  // namespace flownav::regress
