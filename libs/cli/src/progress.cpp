#include "flownav/cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <string>

namespace flownav::cli {

namespace {

constexpr int line_step_percent = 10;
constexpr int bar_characters = 40;

std::string fields_text(std::uint64_t fields) {
    return std::to_string(fields) + (fields == 1 ? " field" : " fields");
}

void put(std::FILE* stream, const std::string& text) {
    // Nobody depends on the progress: when it cannot be shown, the work goes on.
    std::fputs(text.c_str(), stream);
    std::fflush(stream);
}

}  // namespace

Progress::Style Progress::style_for(std::FILE* stream) {
    return isatty(fileno(stream)) != 0 ? Style::Bar : Style::Lines;
}

void Progress::update(double share, std::uint64_t fields) {
    if (style_ == Style::Silent) return;
    int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
    if (style_ == Style::Lines) percent -= percent % line_step_percent;
    if (percent <= last_percent_) return;
    last_percent_ = percent;
    if (style_ == Style::Bar) return draw_bar(percent, fields);
    put(stream_, std::to_string(percent) + " %, " + fields_text(fields) + '\n');
}

void Progress::finish(std::uint64_t fields) {
    if (style_ != Style::Bar) return;
    draw_bar(last_percent_, fields);
    put(stream_, "\n");
}

void Progress::draw_bar(int percent, std::uint64_t fields) {
    const auto done = static_cast<std::size_t>(percent * bar_characters / 100);
    put(stream_, "\r[" + std::string(done, '#') + std::string(bar_characters - done, '.') + "] " +
                     std::to_string(percent) + " %, " + fields_text(fields));
}

}  // namespace flownav::cli
