#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flownav/regress/run_results.h"

namespace flownav::regress {

enum class Verdict { Worse, Unknown, Better };

/// One figure of one rawlog that two runs do not agree on.
struct Change {
    std::string id;
    std::string figure;           ///< empty: what came of the replay, "done" or why it failed
    std::string before, after;    ///< for people; "not there" where a run has no such figure
    std::string difference;       ///< "-21 (-31.8 %)"; empty where one of them is no number
    std::optional<double> share;  ///< of what it was
    double severity = 0.0;        ///< in tolerances, see severity_of(); may be infinite
    Verdict verdict = Verdict::Unknown;
};

/// A setting that differs between the runs, in some of the rawlogs or all.
struct SettingChange {
    std::string key;            ///< section.key
    std::string before, after;  ///< with "(default)" where an ini does not say
    std::size_t rawlogs = 0;
};

/// Two runs side by side.
struct Comparison {
    std::string program_before, program_after;
    bool other_setup = false;             ///< another program or other common settings
    std::vector<SettingChange> settings;  ///< by key
    std::vector<std::string> ids;         ///< in both runs, the worst first, then those without a change
    std::vector<Change> changes;          ///< the worst first, what got better last
    std::vector<std::string> only_before, only_after;  ///< rawlogs of which one run has no result
    std::vector<std::string> other_rawlog;             ///< the same identifier, but another recording
};

/// Where a replay ended differently its figures are not compared: one of them has a part of the drive only.
Comparison compare(const RunResults& before, const RunResults& after);

/// How many tolerances of figure_rule() a change is; beyond 1 it is no noise. Where no difference is allowed
/// at all, a change by 1 counts as ten tolerances; where a number comes or goes, as a hundred.
double severity_of(const std::string& figure, const std::optional<double>& before,
                   const std::optional<double>& after);

/// Rawlogs of a comparison by what changed; better, worse and neither: beyond tolerance, in some figure.
struct Tally {
    std::size_t rawlogs = 0, changed = 0, beyond = 0, worse = 0, better = 0, neither = 0;
};
Tally tally_of(const Comparison& comparison);

}  // namespace flownav::regress
