#pragma once
#include <ostream>
#include <string>

namespace flownav::cli {

/// Whether the stream is the standard output and that is a terminal.
bool is_terminal(const std::ostream& out);

/// A line that tells how far long work is: rewritten on a terminal, else every text is a line of its own.
/// Errors of the stream are ignored.
class StatusLine {
  public:
    StatusLine(std::ostream& out, bool terminal) : out_(out), terminal_(terminal) {}

    bool on_terminal() const { return terminal_; }
    void show(const std::string& text);
    /// Removes the line from the terminal.
    void clear();
    /// Leaves the line on the terminal and begins the next one.
    void end();

  private:
    std::ostream& out_;
    bool terminal_;
    bool open_ = false;  ///< the cursor stands behind the text
};

}  // namespace flownav::cli
