#include "flownav/regress/runner.h"

#include <signal.h>  // NOLINT: the C++ header has no sigset_t
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <list>
#include <set>
#include <system_error>

#include "flownav/cli/exit_status.h"
#include "flownav/io/output_file.h"
#include "flownav/regress/child.h"
#include "flownav/regress/result.h"
#include "flownav/regress/store.h"
#include "flownav/replay/replay.h"

namespace flownav::regress {

namespace {

using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

constexpr auto grace = std::chrono::seconds(2);  // from SIGTERM to SIGKILL
constexpr auto messages_name = "messages.txt";
constexpr auto config_name = "config.ini";
const std::set<std::string> figures_only = {"summary.json", "timing.json", config_name,
                                            messages_name,  result_file,   failure_file};

/// Blocks the signals that the run waits for during its lifetime.
class BlockedSignals {
  public:
    BlockedSignals() {
        sigemptyset(&set_);
        for (const int signal : {SIGCHLD, SIGTERM, SIGINT}) sigaddset(&set_, signal);
        sigprocmask(SIG_BLOCK, &set_, &before_);
    }
    ~BlockedSignals() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
    BlockedSignals(const BlockedSignals&) = delete;
    BlockedSignals& operator=(const BlockedSignals&) = delete;

    /// Waits for a signal. Returns 0 when none comes before `until`.
    int wait(Clock::time_point until) const {
        const auto left =
            std::max(std::chrono::nanoseconds(0), std::chrono::nanoseconds(until - Clock::now()));
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(left);
        const timespec patience{seconds.count(), (left - seconds).count()};
        const int signal = sigtimedwait(&set_, nullptr, &patience);
        return std::max(signal, 0);
    }

  private:
    sigset_t set_{}, before_{};
};

/// A running replay.
struct Running {
    const Job* job;
    ScratchFolder folder;
    pid_t child;
    Clock::time_point patience_ends;
    bool too_long = false;  ///< exceeded the time limit and was told to end
};

std::string seconds_text(double seconds) {
    std::string text = std::to_string(seconds);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string last_line_of(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

void keep_figures_only(const fs::path& folder) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (figures_only.count(entry.path().filename()) == 0) fs::remove_all(entry.path());
}

class Runner {
  public:
    Runner(const std::vector<Job>& jobs, const RunOptions& options, const RunListener& listener)
        : jobs_(jobs), options_(options), listener_(listener) {
        tally_.all = jobs.size();
    }

    RunTally run() {
        std::size_t next = 0;
        while ((next < jobs_.size() && tally_.ended_by_signal == 0) || !running_.empty()) {
            const bool may_start = tally_.ended_by_signal == 0 && next < jobs_.size() &&
                                   running_.size() < static_cast<std::size_t>(options_.jobs);
            if (may_start) {
                begin(jobs_[next++]);
            } else {
                take(signals_.wait(next_deadline()));
                end_what_lasts_too_long();
                collect();
            }
        }
        return tally_;
    }

  private:
    void begin(const Job& job) {
        const Store store(job.output);
        if (!options_.force && store.is_done(job.id, job.key)) {
            ++tally_.skipped;
            return listener_.progress(tally_);
        }
        try {
            start(job, store);
        } catch (const io::OutputError& error) {
            not_stored(job, error.what());
        } catch (const std::system_error& error) {
            not_stored(job, error.what());
        }
    }

    void start(const Job& job, const Store& store) {
        ScratchFolder folder = store.scratch(job.id);
        io::write_file(folder.path() / config_name, job.ini);
        const pid_t child =
            start_child({job.rawlog, job.sha256, job.program.file, folder.path(), folder.path() / config_name,
                         folder.path() / messages_name, folder.lock()});
        const auto limit = std::chrono::duration<double>(options_.time_limit_s);
        const auto ends = Clock::now() + std::chrono::duration_cast<Clock::duration>(limit);
        running_.push_back({&job, std::move(folder), child, ends});
    }

    Clock::time_point next_deadline() const {
        auto first = Clock::now() + std::chrono::hours(1);
        for (const Running& running : running_) first = std::min(first, running.patience_ends);
        return first;
    }

    /// SIGCHLD needs no action here: collect() checks every child.
    void take(int signal) {
        if (signal != SIGTERM && signal != SIGINT) return;
        tally_.ended_by_signal = signal;
        for (Running& running : running_) {
            signal_child(running.child, SIGTERM);
            running.patience_ends = std::min(running.patience_ends, Clock::now() + grace);
        }
    }

    void end_what_lasts_too_long() {
        const auto now = Clock::now();
        for (Running& running : running_) {
            if (now < running.patience_ends) continue;
            const bool told = running.too_long || tally_.ended_by_signal != 0;
            signal_child(running.child, told ? SIGKILL : SIGTERM);
            running.too_long = running.too_long || tally_.ended_by_signal == 0;
            running.patience_ends = now + grace;
        }
    }

    void collect() {
        for (auto at = running_.begin(); at != running_.end();) {
            int state = 0;
            if (waitpid(at->child, &state, WNOHANG) != at->child) {
                ++at;
                continue;
            }
            signal_child(at->child, SIGKILL);  // ends processes that the child may have started
            const Running ended = std::move(*at);
            at = running_.erase(at);
            if (tally_.ended_by_signal == 0) finish(ended, state);
        }
    }

    void finish(const Running& ended, int state) try {
        const int status = WIFEXITED(state) ? WEXITSTATUS(state) : -1;
        if (status == cli::exit_code(cli::ExitStatus::Output) && !ended.too_long)
            throw io::OutputError(tail_of(ended.folder.path() / messages_name));
        part_timing(ended.folder.path());
        Result result = result_of(*ended.job, status, ended.folder.path());
        if (ended.too_long) {
            result.status = -1;
            result.reason = "took longer than " + seconds_text(options_.time_limit_s) + " s";
        } else if (status != 0) {
            result.reason = describe_end(state);
        }
        result.reason.empty() ? store_done(ended, result) : store_failed(ended, result);
        listener_.progress(tally_);
    } catch (const io::OutputError& error) {
        not_stored(*ended.job, error.what());
    } catch (const fs::filesystem_error& error) {
        not_stored(*ended.job, error.what());
    }

    static Result result_of(const Job& job, int status, const fs::path& folder) {
        Result result{job.id, job.key, job.sha256, job.program.version, job.setup, job.ini, status,
                      {},     {},      {}};
        if (const auto figures = read_figures(folder / "summary.json")) result.figures = *figures;
        return result;
    }

    void store_done(const Running& ended, const Result& result) {
        const fs::path& folder = ended.folder.path();
        fs::remove(folder / messages_name);
        if (options_.keep == Keep::FiguresOnly) keep_figures_only(folder);
        io::write_file(folder / result_file, result_text(result));
        Store(ended.job->output).commit_done(ended.folder, result.id, result.key, options_.force);
        ++tally_.replayed;
        const auto duration_s = result.figures.find("drive.duration_s");
        if (duration_s != result.figures.end()) tally_.driven_s += duration_s->second.value_or(0.0);
    }

    void store_failed(const Running& ended, Result& result) {
        result.messages = tail_of(ended.folder.path() / messages_name);
        io::write_file(ended.folder.path() / failure_file, result_text(result));
        Store(ended.job->output).commit_failed(ended.folder, result.id, result.key);
        ++tally_.failed;
        const std::string last_line = last_line_of(result.messages);
        listener_.problem(ended.job->title + ": " + result.reason +
                          (last_line.empty() ? "" : ": " + last_line));
    }

    void not_stored(const Job& job, const std::string& why) {
        ++tally_.not_stored;
        listener_.problem(job.title + ": " + why);
        listener_.progress(tally_);
    }

    const std::vector<Job>& jobs_;
    const RunOptions& options_;
    const RunListener& listener_;
    BlockedSignals signals_;
    RunTally tally_;
    std::list<Running> running_;
};

}  // namespace

RunTally run_jobs(const std::vector<Job>& jobs, const RunOptions& options, const RunListener& listener) {
    std::set<fs::path> cleaned;
    for (const Job& job : jobs)
        if (cleaned.insert(job.output).second) Store(job.output).remove_left_overs();
    return Runner(jobs, options, listener).run();
}

}  // namespace flownav::regress
