#include "flownav/cli/status_line.h"

#include <unistd.h>

#include <iostream>

namespace flownav::cli {

namespace {

constexpr const char* clear_to_end = "\x1b[K";

}  // namespace

bool is_terminal(const std::ostream& out) {
    return &out == &std::cout && isatty(STDOUT_FILENO) != 0;
}

void StatusLine::show(const std::string& text) {
    if (!terminal_) {
        out_ << text << std::endl;
        return;
    }
    out_ << '\r' << text << clear_to_end << std::flush;
    open_ = true;
}

void StatusLine::clear() {
    if (open_) out_ << '\r' << clear_to_end << std::flush;
    open_ = false;
}

void StatusLine::end() {
    if (open_) out_ << std::endl;
    open_ = false;
}

}  // namespace flownav::cli
