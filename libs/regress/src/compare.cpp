#include <filesystem>

#include "compare_page.h"
#include "figure_text.h"
#include "flownav/cli/usage_error.h"
#include "flownav/regress/commands.h"
#include "flownav/regress/comparison_text.h"
#include "flownav/regress/exit_status.h"

namespace flownav::regress {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_lines = 40;

RunResults results_in(const fs::path& folder) {
    RunResults results = collect_all(folder);
    if (count(Outcome::Missing, results) == results.size())
        throw cli::UsageError(folder.string() + ": no results of flownav-regress run there");
    return results;
}

void say_changes(const Comparison& comparison, const fs::path& page, std::ostream& out) {
    out << change_table(comparison, most_lines);
    if (comparison.changes.size() > most_lines)
        out << "... " << comparison.changes.size() - most_lines << " more, see " << page.string() << '\n';
}

void say_summary(const Comparison& comparison, const fs::path& page, std::ostream& out) {
    for (const std::string& line : what_differs(comparison)) out << line << '\n';
    out << tally_text(tally_of(comparison)) << "\nPage: " << page.string() << '\n';
}

}  // namespace

int run_compare(const Options& options, std::ostream& out) {
    const fs::path& folder_before = options.folders.at(0);
    const fs::path& folder_after = options.folders.at(1);
    const fs::path page = options.output.empty() ? folder_after / "compare.html" : options.output;
    const NamedRuns runs{folder_before.string(), folder_after.string(), results_in(folder_before),
                         results_in(folder_after)};
    const Comparison comparison = compare(runs.before, runs.after);
    write_atomically(page, compare_html(comparison, runs));
    say_changes(comparison, page, out);
    if (!options.quiet) say_summary(comparison, page, out);
    return comparison.only_before.empty() && comparison.only_after.empty() ? exit_fine : exit_failed;
}

}  // namespace flownav::regress
