#include "run_progress.h"

#include "flownav/cli/number_text.h"

namespace flownav::regress {

namespace {

std::size_t finished(const RunTally& tally) {
    return tally.skipped + tally.replayed + tally.failed + tally.not_stored;
}

std::string counts(const RunTally& tally) {
    std::string text = std::to_string(tally.replayed) + " replayed";
    if (tally.skipped > 0) text += ", " + std::to_string(tally.skipped) + " done before";
    if (tally.failed > 0) text += ", " + std::to_string(tally.failed) + " failed";
    if (tally.not_stored > 0) text += ", " + std::to_string(tally.not_stored) + " could not be stored";
    return text;
}

}  // namespace

RunProgress::RunProgress(std::ostream& out, bool quiet)
    : out_(out), line_(out, cli::is_terminal(out)), quiet_(quiet) {}

void RunProgress::show(const RunTally& tally) {
    if (quiet_) return;
    const std::size_t tenths = 10 * finished(tally) / tally.all;
    if (!line_.on_terminal() && tenths == tenths_shown_) return;
    tenths_shown_ = tenths;
    line_.show(std::to_string(finished(tally)) + " of " + std::to_string(tally.all) + ": " + counts(tally));
}

void RunProgress::say(std::ostream& to, const std::string& line) {
    line_.clear();
    to << line << std::endl;
}

void RunProgress::finish(const RunTally& tally) {
    line_.clear();
    if (quiet_) return;
    const double seconds = elapsed_s();
    out_ << tally.all << (tally.all == 1 ? " rawlog: " : " rawlogs: ") << counts(tally) << ", in "
         << cli::fixed_text(seconds, 1) << " s";
    if (tally.driven_s > 0.0 && seconds > 0.0)
        out_ << "; " << cli::fixed_text(tally.driven_s / seconds, 1) << " s of driving per second";
    out_ << std::endl;
}

double RunProgress::elapsed_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace flownav::regress
