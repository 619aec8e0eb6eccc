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
    int jobs = 1;                  ///< replays at the same time
    double time_limit_s = 1800.0;  ///< of one replay
    Keep keep = Keep::All;
    bool force = false;  ///< also what is done
};

/// How far a run is, and what came of it.
struct RunTally {
    std::size_t all = 0;
    std::size_t skipped = 0;     ///< done before
    std::size_t replayed = 0;    ///< and fine
    std::size_t failed = 0;      ///< see failed/ID
    std::size_t not_stored = 0;  ///< could not be written; try again
    double driven_s = 0.0;       ///< length of the recordings that were replayed
    int ended_by_signal = 0;     ///< SIGTERM or SIGINT, or 0
};

/// Who is told while it goes on.
struct RunListener {
    std::function<void(const RunTally&)> progress;    ///< after each rawlog
    std::function<void(const std::string&)> problem;  ///< a sentence for each one that failed
};

/// Replays every job that is not done, each in a process of its own with a time limit, and stores what comes
/// of it. One that fails does not stop the others. SIGTERM and SIGINT end it with nothing half stored; the
/// process must have no other threads. Throws OutputError when there can be no folder for the results.
RunTally run_jobs(const std::vector<Job>& jobs, const RunOptions& options, const RunListener& listener);

}  // namespace flownav::regress
