#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "flownav/regress/figure_rules.h"
#include "flownav/regress/run_results.h"

namespace flownav::regress {

/// A golden figure; without a value the summary says null.
struct ExpectedFigure {
    std::optional<double> value;
    Tolerance tolerance;
};

/// Expected figures of one rawlog.
struct ExpectedRawlog {
    int status = 0;  ///< exit status of the replay; 2 for a damaged recording
    std::map<std::string, ExpectedFigure> figures;
};

/// The content of expected.json.
struct Expectation {
    std::string replayed_by;  ///< program and version that produced the figures
    std::map<std::string, ExpectedRawlog> rawlogs;
};

/// Reads an expectation. Throws UsageError for a missing file, invalid JSON, another format, or a value of
/// the wrong kind, naming it.
Expectation read_expectation(const std::filesystem::path& file);

std::string expectation_text(const Expectation& expectation);

/// One deviation from the expectation.
struct Deviation {
    std::string id;
    std::string figure;   ///< empty: concerns the whole rawlog
    std::string message;  ///< for the user
};

/// Returns the figures that are out of tolerance in the order of the results, then the expected rawlogs that
/// are not in the manifest. Figures of parts of the summary that the expectation of a rawlog lacks altogether
/// are not checked: see unchecked_parts().
std::vector<Deviation> check(const Expectation& expectation, const RunResults& results);

/// Parts of the summary, such as "contacts", that some result has and the expectation of its rawlog lacks
/// altogether, because it was accepted by a version without them.
std::set<std::string> unchecked_parts(const Expectation& expectation, const RunResults& results);

/// Returns the expectation that these results meet. Known figures keep their tolerances; new ones get those
/// of figure_rule(). Expectations of missing results are kept for rawlogs in the manifest.
Expectation accept(const Expectation& before, const RunResults& results);

/// Returns one line per difference of two expectations.
std::vector<std::string> difference(const Expectation& before, const Expectation& after);

}  // namespace flownav::regress
