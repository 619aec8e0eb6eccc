#pragma once

#include <chrono>
#include <ostream>
#include <string>

#include "flownav/regress/runner.h"

namespace flownav::regress {

/// Tells people how far a run is: one line that is rewritten on a terminal, else a line every ten percent.
class RunProgress {
  public:
    RunProgress(std::ostream& out, bool quiet);

    void show(const RunTally& tally);

    /// A line of its own, whether quiet or not.
    void say(std::ostream& to, const std::string& line);

    /// What came of it, unless quiet.
    void finish(const RunTally& tally);

  private:
    double elapsed_s() const;
    void clear_line();

    std::ostream& out_;
    bool quiet_;
    bool terminal_;
    std::size_t tenths_shown_ = 0;
    bool line_is_open_ = false;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace flownav::regress
