#pragma once
#include <string>

#include "flownav/cli/status_line.h"
#include "grabber.h"

namespace flownav {

/// Shows the recording's length and size: twice a second on a terminal, else every 10 s.
class GrabProgress {
  public:
    GrabProgress(std::ostream& out, bool quiet) : line_(out, cli::is_terminal(out)), quiet_(quiet) {}

    void update(double elapsed_s, const WriterCounts& counts);

    /// Ends the line on a terminal.
    void finish() { line_.end(); }

  private:
    cli::StatusLine line_;
    bool quiet_;
    double next_s_ = 1.0;
};

/// Returns a summary such as "310 observations in 12.4 s (CAMERA1 300, ODOMETRY 10), 3.1 MB in drive.rawlog".
std::string outcome_text(const Grabber& grabber);

}  // namespace flownav
