#pragma once
#include <cstdint>
#include <cstdio>

namespace flownav::cli {

/// Tells people how far long work is: a bar that is redrawn on a terminal, else a line every 10 percent.
class Progress {
  public:
    enum class Style { Silent, Lines, Bar };

    /// A bar when `stream` is a terminal, else lines.
    static Style style_for(std::FILE* stream);

    Progress(std::FILE* stream, Style style) : stream_(stream), style_(style) {}

    /// `share` of the work done, 0..1, and the fields so far.
    void update(double share, std::uint64_t fields);

    /// Ends the line of a bar.
    void finish(std::uint64_t fields);

  private:
    void draw_bar(int percent, std::uint64_t fields);

    std::FILE* stream_;
    Style style_;
    int last_percent_ = 0;
};

}  // namespace flownav::cli
