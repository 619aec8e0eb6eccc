#pragma once
#include <string>

#include "flownav/cli/progress.h"
#include "grabber.h"

namespace flownav {

/// Shows that the recording grows: one line that is redrawn on a terminal, else a line every 10 s.
class GrabProgress {
  public:
    explicit GrabProgress(cli::Progress::Style style) : style_(style) {}

    void update(double elapsed_s, const WriterCounts& counts);

    /// Ends the line on a terminal.
    void finish() const;

  private:
    cli::Progress::Style style_;
    double next_s_ = 1.0;
    bool drawn_ = false;
};

/// "310 observations in 12.4 s (CAMERA1 300, ODOMETRY 10), 3.1 MB in drive.rawlog"
std::string outcome_text(const Grabber& grabber);

}  // namespace flownav
