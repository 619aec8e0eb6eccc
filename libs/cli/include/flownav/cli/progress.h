#pragma once
#include <cstdint>

#include "flownav/cli/status_line.h"

namespace flownav::cli {

/// Shows the share of long work that is done: a bar on a terminal, else a line every 10 percent.
class Progress {
  public:
    enum class Style { Silent, Lines, Bar };

    /// A bar when `out` is a terminal, else lines.
    static Style style_for(const std::ostream& out);

    Progress(std::ostream& out, Style style) : line_(out, style == Style::Bar), style_(style) {}

    /// `share` of the work done, 0..1, and the fields so far.
    void update(double share, std::uint64_t fields);

    /// Ends the line of a bar.
    void finish(std::uint64_t fields);

  private:
    void draw_bar(int percent, std::uint64_t fields);

    StatusLine line_;
    Style style_;
    int last_percent_ = 0;
};

}  // namespace flownav::cli
