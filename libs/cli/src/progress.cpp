#include "flownav/cli/progress.h"

#include <algorithm>

namespace flownav::cli {

namespace {

constexpr int line_step_percent = 10;
constexpr int bar_characters = 40;

std::string fields_text(std::uint64_t fields) {
    return std::to_string(fields) + (fields == 1 ? " field" : " fields");
}

}  // namespace

Progress::Style Progress::style_for(const std::ostream& out) {
    return is_terminal(out) ? Style::Bar : Style::Lines;
}

void Progress::update(double share, std::uint64_t fields) {
    if (style_ == Style::Silent) return;
    int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
    if (style_ == Style::Lines) percent -= percent % line_step_percent;
    if (percent <= last_percent_) return;
    last_percent_ = percent;
    if (style_ == Style::Bar) return draw_bar(percent, fields);
    line_.show(std::to_string(percent) + " %, " + fields_text(fields));
}

void Progress::finish(std::uint64_t fields) {
    if (style_ != Style::Bar) return;
    draw_bar(last_percent_, fields);
    line_.end();
}

void Progress::draw_bar(int percent, std::uint64_t fields) {
    const auto done = static_cast<std::size_t>(percent * bar_characters / 100);
    line_.show('[' + std::string(done, '#') + std::string(bar_characters - done, '.') + "] " +
               std::to_string(percent) + " %, " + fields_text(fields));
}

}  // namespace flownav::cli
