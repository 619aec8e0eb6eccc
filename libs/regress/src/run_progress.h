#pragma once

#include <chrono>
#include <ostream>
#include <string>

#include "flownav/cli/status_line.h"
#include "flownav/regress/runner.h"

namespace flownav::regress {

/// Shows how far a run is: with every rawlog on a terminal, else every ten percent.
class RunProgress {
  public:
    RunProgress(std::ostream& out, bool quiet);

    void show(const RunTally& tally);

    /// Writes a line, also when quiet.
    void say(std::ostream& to, const std::string& line);

    /// Shows the counts and the time of the whole run, unless quiet.
    void finish(const RunTally& tally);

  private:
    double elapsed_s() const;

    std::ostream& out_;
    cli::StatusLine line_;
    bool quiet_;
    std::size_t tenths_shown_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace flownav::regress
