#include "grab_progress.h"

#include "flownav/cli/number_text.h"

namespace flownav {

namespace {

std::uint64_t sum(const std::map<std::string, std::uint64_t>& counts) {
    std::uint64_t all = 0;
    for (const auto& [label, count] : counts) all += count;
    return all;
}

std::string megabytes(std::uint64_t bytes) {
    return cli::fixed_text(static_cast<double>(bytes) / 1e6, 1) + " MB";
}

std::string plural(std::uint64_t count, const std::string& what) {
    return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

}  // namespace

void GrabProgress::update(double elapsed_s, const WriterCounts& counts) {
    if (quiet_ || elapsed_s < next_s_) return;
    next_s_ = elapsed_s + (line_.on_terminal() ? 0.5 : 10.0);
    const std::uint64_t dropped = sum(counts.dropped);
    const std::string text =
        cli::fixed_text(elapsed_s, 1) + " s, " + plural(sum(counts.written), "observation") + ", " +
        megabytes(counts.file_bytes) +
        (counts.queue_bytes > 1000000 ? ", waiting " + megabytes(counts.queue_bytes) : "") +
        (dropped > 0 ? ", DROPPED " + std::to_string(dropped) : "");
    line_.show(text);
}

std::string outcome_text(const Grabber& grabber) {
    const WriterCounts counts = grabber.counts();
    std::string labels;
    for (const auto& [label, count] : counts.written)
        labels += (labels.empty() ? " (" : ", ") + label + ' ' + std::to_string(count);
    if (!labels.empty()) labels += ')';
    std::string files;
    for (const auto& file : grabber.files()) files += (files.empty() ? "" : ", ") + file.string();
    std::string text = plural(sum(counts.written), "observation") + " in " +
                       cli::fixed_text(grabber.elapsed_s(), 1) + " s" + labels + ", " +
                       megabytes(counts.file_bytes) + " in " + files;
    if (counts.late > 0) text += "; " + std::to_string(counts.late) + " came too late for the order of time";
    return text;
}

}  // namespace flownav
