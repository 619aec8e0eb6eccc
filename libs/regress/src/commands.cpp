#include "flownav/regress/commands.h"

#include <fstream>
#include <iostream>
#include <system_error>

#include "figure_text.h"
#include "flownav/cli/usage_error.h"
#include "flownav/io/output_file.h"
#include "flownav/regress/exit_status.h"
#include "flownav/regress/expectation.h"
#include "flownav/regress/junit.h"
#include "flownav/regress/manifest.h"
#include "flownav/regress/run_results.h"
#include "flownav/regress/store.h"
#include "run_progress.h"

namespace flownav::regress {

namespace fs = std::filesystem;

namespace {

template <class Item>
std::vector<Item> part_of(const std::vector<Item>& items, const std::optional<Shard>& shard) {
    if (!shard) return items;
    std::vector<Item> part;
    for (std::size_t k = 0; k < items.size(); ++k)
        if (shard->has(k)) part.push_back(items[k]);
    return part;
}

/// Writes merged.json and merged.csv.
void write_merged(const fs::path& output, const RunResults& results) {
    write_atomically(output / "merged.json", merged_json(results));
    write_atomically(output / "merged.csv", merged_csv(results));
}

RunResults results_of(const Options& options) {
    const Manifest manifest = read_manifest(options.manifest);
    if (!fs::is_directory(options.output))
        throw cli::UsageError("--output " + options.output.string() + ": no such folder");
    return collect(manifest, options.output);
}

RunResults unmixed_results_of(const Options& options) {
    RunResults results = results_of(options);
    const std::string mixture = mixture_in(results);
    if (!mixture.empty())
        throw cli::UsageError(options.output.string() + ": " + mixture + "; run again with one of them");
    return results;
}

void refuse_other_version(const Expectation& expectation, const RunResults& results, const Options& options) {
    const std::string program = program_of(results);
    if (options.any_version || program.empty() || program == expectation.replayed_by) return;
    throw cli::UsageError("expectation " + options.expected.string() + " is of " + expectation.replayed_by +
                          ", the results are of " + program +
                          ": accept them, or compare all the same with --any-version");
}

void say_deviations(const std::vector<Deviation>& deviations, std::ostream& out) {
    std::string id;
    for (const Deviation& deviation : deviations) {
        if (deviation.id != id) out << deviation.id << '\n';
        id = deviation.id;
        out << "    " << (deviation.figure.empty() ? "" : deviation.figure + ": ") << deviation.message
            << '\n';
    }
}

std::size_t rawlogs_in(const std::vector<Deviation>& deviations) {
    std::size_t number = 0;
    for (std::size_t k = 0; k < deviations.size(); ++k)
        if (k == 0 || deviations[k].id != deviations[k - 1].id) ++number;
    return number;
}

}  // namespace

void write_atomically(const fs::path& file, const std::string& text) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const ScratchFolder scratch(folder, "." + file.filename().string());
    io::write_file(scratch.path() / "new", text);
    std::error_code error;
    fs::rename(scratch.path() / "new", file, error);
    if (error) throw io::OutputError("cannot write " + file.string() + ": " + error.message());
}

RunTally replay_all(const std::vector<Job>& jobs, const Options& options, std::ostream& out,
                    std::ostream& error) {
    RunProgress progress(out, options.quiet);
    const RunListener listener{
        [&](const RunTally& tally) { progress.show(tally); },
        [&](const std::string& problem) { progress.say(error, "flownav-regress: " + problem); }};
    const RunTally tally = run_jobs(part_of(jobs, options.shard), options.run, listener);
    progress.finish(tally);
    return tally;
}

int status_of(const RunTally& tally) {
    if (tally.ended_by_signal != 0) return exit_by_signal + tally.ended_by_signal;
    if (tally.not_stored > 0) return exit_try_again;
    return tally.failed > 0 ? exit_failed : exit_fine;
}

int run_manifest(const Options& options, std::ostream& out) {
    const fs::path folder = fs::absolute(options.folders.front()).lexically_normal();
    if (!fs::is_directory(folder))
        throw cli::UsageError(options.folders.front().string() + ": no such folder");
    const bool to_file = !options.output.empty();
    const fs::path root =
        to_file ? fs::absolute(options.output).lexically_normal().parent_path() : fs::current_path();
    const std::string text = manifest_of_folder(folder, root);
    if (!to_file) {
        out << text;
        return exit_fine;
    }
    write_atomically(options.output, text);
    if (!options.quiet)
        out << count_text(parse_manifest(text, "").size(), "rawlog") << " in " << options.output.string()
            << '\n';
    return exit_fine;
}

int run_run(const Options& options, std::ostream& out, std::ostream& error) {
    const Manifest manifest = read_manifest(options.manifest);
    const JobSetup setup{options.root, options.config, options.settings, find_replay_program(options.program),
                         options.output};
    const RunTally tally = replay_all(make_jobs(manifest, setup), options, out, error);
    if (!options.shard && tally.ended_by_signal == 0) {
        write_merged(options.output, collect(manifest, options.output));
        if (!options.quiet) out << "Results: " << (options.output / "merged.csv").string() << '\n';
    }
    return status_of(tally);
}

int run_merge(const Options& options, std::ostream& out, std::ostream& error) {
    const RunResults results = unmixed_results_of(options);
    const bool complete = count(Outcome::Done, results) == results.size();
    const int status = complete ? exit_fine : exit_incomplete;
    if (options.missing || options.failed) {
        for (const auto& [asked, outcome] :
             {std::pair(options.missing, Outcome::Missing), std::pair(options.failed, Outcome::Failed)}) {
            const std::string lines = asked ? lines_with(outcome, results) : "";
            if (!lines.empty()) out << lines << '\n';
        }
        return status;
    }
    write_merged(options.output, results);
    for (const RawlogResult& rawlog : results)
        if (rawlog.outcome != Outcome::Done)
            error << "flownav-regress: " << rawlog.id << ": " << to_string(rawlog.outcome)
                  << (rawlog.result.reason.empty() ? "" : ", " + rawlog.result.reason) << '\n';
    if (!options.quiet)
        out << count_text(results.size(), "rawlog") << ": " << count(Outcome::Done, results) << " done, "
            << count(Outcome::Failed, results) << " failed, " << count(Outcome::Missing, results)
            << " missing; see " << (options.output / "merged.csv").string() << '\n';
    return status;
}

int run_check(const Options& options, std::ostream& out) {
    const RunResults results = unmixed_results_of(options);
    const Expectation expectation = read_expectation(options.expected);
    refuse_other_version(expectation, results, options);
    const std::vector<Deviation> deviations = check(expectation, results);
    if (!options.junit.empty())
        write_atomically(options.junit, junit_xml(options.manifest.filename(), results, deviations));
    say_deviations(deviations, out);
    for (const std::string& part : unchecked_parts(expectation, results)) {
        out << "not checked: " << part << ", which " << options.expected.filename().string()
            << " does not have; see flownav-regress accept\n";
    }
    if (!options.quiet)
        out << count_text(results.size(), "rawlog") << ", " << rawlogs_in(deviations)
            << " not as expected: " << count_text(deviations.size(), "figure") << " out of tolerance\n";
    return deviations.empty() ? exit_fine : exit_failed;
}

int run_accept(const Options& options, std::ostream& out) {
    const RunResults results = unmixed_results_of(options);
    const Expectation before =
        fs::exists(options.expected) ? read_expectation(options.expected) : Expectation{};
    const Expectation after = accept(before, results);
    const std::vector<std::string> changes = difference(before, after);
    for (const std::string& line : changes) out << line << '\n';
    write_atomically(options.expected, expectation_text(after));
    if (!options.quiet)
        out << count_text(changes.size(), "change") << "; " << options.expected.string() << " expects "
            << count_text(after.rawlogs.size(), "rawlog") << '\n';
    return count(Outcome::Missing, results) == 0 ? exit_fine : exit_incomplete;
}

}  // namespace flownav::regress
