#pragma once

#include <ostream>

#include "flownav/regress/regress_options.h"

namespace flownav::regress {

/// The commands of flownav-regress: options to exit status. They throw UsageError, ConfigError and
/// OutputError.
int run_manifest(const Options& options, std::ostream& out);
int run_run(const Options& options, std::ostream& out, std::ostream& error);
int run_merge(const Options& options, std::ostream& out, std::ostream& error);
int run_check(const Options& options, std::ostream& out);
int run_accept(const Options& options, std::ostream& out);
int run_compare(const Options& options, std::ostream& out);
int run_sweep(const Options& options, std::ostream& out, std::ostream& error);

/// Replays `jobs` with progress on `out` and problems on `error`, and says what came of it.
RunTally replay_all(const std::vector<Job>& jobs, const Options& options, std::ostream& out,
                    std::ostream& error);

/// The exit status that a run deserves.
int status_of(const RunTally& tally);

/// A whole file, there in one step or not at all. Throws OutputError.
void write_atomically(const std::filesystem::path& file, const std::string& text);

}  // namespace flownav::regress
