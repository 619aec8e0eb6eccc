#pragma once

#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "flownav/regress/job.h"

namespace flownav::regress {

enum class Keep { All, FiguresOnly };

struct RunOptions {
    int jobs = 1;                  ///< number of parallel replays
    double time_limit_s = 1800.0;  ///< limit of one replay
    Keep keep = Keep::All;
    bool force = false;  ///< repeats finished jobs too
};

/// Counts of a run.
struct RunTally {
    std::size_t all = 0;
    std::size_t skipped = 0;     ///< finished by an earlier run
    std::size_t replayed = 0;    ///< replayed successfully
    std::size_t failed = 0;      ///< failed replays, see failed/ID
    std::size_t not_stored = 0;  ///< results that could not be written; try again
    double driven_s = 0.0;       ///< length of the recordings that were replayed
    int ended_by_signal = 0;     ///< SIGTERM or SIGINT, or 0
};

/// Callbacks of a run.
struct RunListener {
    std::function<void(const RunTally&)> progress;    ///< called after each rawlog
    std::function<void(const std::string&)> problem;  ///< called with a sentence for each failed rawlog
};

/// Replays every job that is not done, each in its own process with a time limit, and stores the results. A
/// failed job does not stop the others. SIGTERM and SIGINT end the run without partial results; the process
/// must have no other threads. Throws OutputError when the result folder cannot be created.
RunTally run_jobs(const std::vector<Job>& jobs, const RunOptions& options, const RunListener& listener);

}  // namespace flownav::regress
