#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flownav/regress/figure_rules.h"
#include "flownav/regress/run_results.h"

namespace flownav::regress {

/// A golden figure; no value: the summary says null.
struct ExpectedFigure {
    std::optional<double> value;
    Tolerance tolerance;
};

/// What is expected of one rawlog.
struct ExpectedRawlog {
    int status = 0;  ///< of the replay; a damaged recording is expected to give flownav-replay's 2
    std::map<std::string, ExpectedFigure> figures;
};

/// The content of expected.json.
struct Expectation {
    std::string replayed_by;  ///< program and version that the figures are of
    std::map<std::string, ExpectedRawlog> rawlogs;
};

/// Throws UsageError: no such file, no JSON, another format, a value of the wrong kind, naming it.
Expectation read_expectation(const std::filesystem::path& file);

std::string expectation_text(const Expectation& expectation);

/// One thing that is not as expected.
struct Deviation {
    std::string id;
    std::string figure;   ///< empty: the rawlog as a whole
    std::string message;  ///< in words
};

/// Everything that is out of tolerance, in the order of the results, then what is expected but not in the
/// manifest.
std::vector<Deviation> check(const Expectation& expectation, const RunResults& results);

/// The expectation that these results meet. Tolerances of figures that were expected before are kept; new
/// ones get those of figure_rule(). What the results miss is kept as it was, when it is in the manifest at
/// all.
Expectation accept(const Expectation& before, const RunResults& results);

/// A line for each thing that differs between two expectations.
std::vector<std::string> difference(const Expectation& before, const Expectation& after);

}  // namespace flownav::regress
