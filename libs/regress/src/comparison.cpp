#include "flownav/regress/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "figure_text.h"
#include "flownav/regress/figure_rules.h"
#include "setting_changes.h"

namespace flownav::regress {

namespace {

constexpr double where_none_is_allowed = 0.1;
constexpr double of_coming_and_going = 100.0;
constexpr auto not_there = "not there";

const std::optional<double>* find(const Figures& figures, const std::string& name) {
    const auto found = figures.find(name);
    return found == figures.end() ? nullptr : &found->second;
}

/// A rated figure that is missing afterwards counts as worse.
Verdict verdict_of(const std::string& figure, const std::optional<double>& before,
                   const std::optional<double>& after) {
    const Better better = figure_rule(figure, before.value_or(0.0)).better;
    if (better == Better::Unknown || (!before && !after)) return Verdict::Unknown;
    const int verdict = !after ? -1 : !before ? 1 : verdict_on(better, *before, *after);
    return verdict < 0 ? Verdict::Worse : verdict > 0 ? Verdict::Better : Verdict::Unknown;
}

std::string text_of(const std::optional<double>* value) {
    return value == nullptr ? not_there : value_text(*value);
}

/// `before` and `after`: null when that run has no such figure.
Change change_of(const std::string& id, const std::string& figure, const std::optional<double>* before,
                 const std::optional<double>* after) {
    Change change{id, figure, text_of(before), text_of(after), "", {}, 0.0, Verdict::Unknown};
    const std::optional<double> was = before == nullptr ? std::nullopt : *before;
    const std::optional<double> is = after == nullptr ? std::nullopt : *after;
    change.severity = severity_of(figure, was, is);
    if (before != nullptr && after != nullptr) change.verdict = verdict_of(figure, was, is);
    if (!was || !is) return change;
    change.difference = difference_text(*was, *is);
    if (*was != 0.0) change.share = (*is - *was) / std::abs(*was);
    return change;
}

bool same(const std::optional<double>* before, const std::optional<double>* after) {
    return before != nullptr && after != nullptr && *before == *after;
}

void compare_figures(const RawlogResult& before, const RawlogResult& after, std::vector<Change>& changes) {
    for (const std::string& name : figure_names({before, after})) {
        const auto* was = find(before.result.figures, name);
        const auto* is = find(after.result.figures, name);
        if (!same(was, is)) changes.push_back(change_of(before.id, name, was, is));
    }
}

std::string outcome_text(const RawlogResult& rawlog) {
    const std::string& reason = rawlog.result.reason;
    return to_string(rawlog.outcome) + (reason.empty() ? "" : ": " + reason);
}

Change outcome_change(const RawlogResult& before, const RawlogResult& after) {
    const bool was_done = before.outcome == Outcome::Done;
    const bool is_done = after.outcome == Outcome::Done;
    return {before.id,
            "",
            outcome_text(before),
            outcome_text(after),
            {},
            {},
            std::numeric_limits<double>::infinity(),
            was_done && !is_done   ? Verdict::Worse
            : !was_done && is_done ? Verdict::Better
                                   : Verdict::Unknown};
}

void compare_rawlog(const RawlogResult& before, const RawlogResult& after, std::vector<Change>& changes) {
    if (before.outcome != after.outcome || before.result.status != after.result.status ||
        before.result.reason != after.result.reason) {
        changes.push_back(outcome_change(before, after));
    } else {
        compare_figures(before, after, changes);
    }
}

/// Order of the changes: improvements last, the others by falling severity.
bool is_worse(const Change& one, const Change& other) {
    const bool better = one.verdict == Verdict::Better;
    if (better != (other.verdict == Verdict::Better)) return !better;
    if (one.severity != other.severity) return one.severity > other.severity;
    return one.verdict < other.verdict;
}

std::map<std::string, const RawlogResult*> results_by_id(const RunResults& results) {
    std::map<std::string, const RawlogResult*> by_id;
    for (const RawlogResult& rawlog : results)
        if (rawlog.outcome != Outcome::Missing) by_id[rawlog.id] = &rawlog;
    return by_id;
}

std::vector<std::string> worst_first(std::set<std::string> ids, const std::vector<Change>& changes) {
    std::vector<std::string> order;
    for (const Change& change : changes)
        if (ids.erase(change.id) == 1) order.push_back(change.id);
    order.insert(order.end(), ids.begin(), ids.end());
    return order;
}

}  // namespace

double severity_of(const std::string& figure, const std::optional<double>& before,
                   const std::optional<double>& after) {
    if (!before || !after) return of_coming_and_going;
    const double width = figure_rule(figure, *before).tolerance.width(*before);
    return std::abs(*after - *before) / (width > 0.0 ? width : where_none_is_allowed);
}

Comparison compare(const RunResults& before, const RunResults& after) {
    Comparison comparison;
    comparison.program_before = program_of(before);
    comparison.program_after = program_of(after);
    const auto in_before = results_by_id(before);
    const auto in_after = results_by_id(after);
    std::set<std::string> ids;
    SettingChanges settings;
    for (const auto& [id, was] : in_before) {
        const auto found = in_after.find(id);
        if (found == in_after.end()) {
            comparison.only_before.push_back(id);
            continue;
        }
        const RawlogResult& is = *found->second;
        ids.insert(id);
        compare_rawlog(*was, is, comparison.changes);
        settings.add(was->result.ini, is.result.ini);
        if (was->result.setup != is.result.setup) comparison.other_setup = true;
        if (was->result.rawlog_sha256 != is.result.rawlog_sha256) comparison.other_rawlog.push_back(id);
    }
    for (const auto& [id, is] : in_after)
        if (in_before.count(id) == 0) comparison.only_after.push_back(id);
    std::stable_sort(comparison.changes.begin(), comparison.changes.end(), is_worse);
    comparison.ids = worst_first(std::move(ids), comparison.changes);
    comparison.settings = settings.all();
    return comparison;
}

Tally tally_of(const Comparison& comparison) {
    std::set<std::string> changed, beyond, worse, better, neither;
    for (const Change& change : comparison.changes) {
        changed.insert(change.id);
        if (change.severity <= 1.0) continue;
        beyond.insert(change.id);
        (change.verdict == Verdict::Worse    ? worse
         : change.verdict == Verdict::Better ? better
                                             : neither)
            .insert(change.id);
    }
    return {comparison.ids.size(), changed.size(), beyond.size(),
            worse.size(),          better.size(),  neither.size()};
}

}  // namespace flownav::regress
