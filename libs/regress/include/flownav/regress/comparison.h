#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flownav/regress/run_results.h"

namespace flownav::regress {

enum class Verdict { Worse, Unknown, Better };

/// One figure of one rawlog that differs between two runs.
struct Change {
    std::string id;
    std::string figure;           ///< empty: the outcome of the replay, "done" or the reason of its failure
    std::string before, after;    ///< as text; "not there" when a run has no such figure
    std::string difference;       ///< such as "-21 (-31.8 %)"; empty when one of them is not a number
    std::optional<double> share;  ///< difference relative to `before`
    double severity = 0.0;        ///< in tolerances, see severity_of(); may be infinite
    Verdict verdict = Verdict::Unknown;
};

/// A setting that differs between the runs for at least one rawlog.
struct SettingChange {
    std::string key;            ///< section.key
    std::string before, after;  ///< with "(default)" when an ini does not set it
    std::size_t rawlogs = 0;
};

/// Comparison of two runs.
struct Comparison {
    std::string program_before, program_after;
    bool other_setup = false;             ///< program or common settings differ
    std::vector<SettingChange> settings;  ///< by key
    std::vector<std::string> ids;  ///< rawlogs in both runs, the worst first, those without a change last
    std::vector<Change> changes;   ///< the worst first, improvements last
    std::vector<std::string> only_before, only_after;  ///< rawlogs with a result in one run only
    std::vector<std::string> other_rawlog;  ///< rawlogs with the same identifier but another recording
};

/// Compares two runs. When the outcome of a replay differs, its figures are not compared, because one of them
/// covers only part of the drive.
Comparison compare(const RunResults& before, const RunResults& after);

/// Size of a change in tolerances of figure_rule(); above 1 it is significant. Without any tolerance a change
/// by 1 counts as ten tolerances; a number that appears or disappears counts as a hundred.
double severity_of(const std::string& figure, const std::optional<double>& before,
                   const std::optional<double>& after);

/// Counts of rawlogs by their changes. better, worse and neither count changes beyond tolerance in at least
/// one figure.
struct Tally {
    std::size_t rawlogs = 0, changed = 0, beyond = 0, worse = 0, better = 0, neither = 0;
};
Tally tally_of(const Comparison& comparison);

}  // namespace flownav::regress
