#include "flownav/regress/expectation.h"

#include <cmath>

#include "figure_text.h"

namespace flownav::regress {

namespace {

std::string status_text(int status) {
    return status < 0 ? "not ended by itself" : std::to_string(status);
}

/// The part of the summary that holds a figure: the name up to its first point.
std::string part_of(const std::string& figure) {
    return figure.substr(0, figure.find('.'));
}

/// Parts of the summary that hold expected figures.
std::set<std::string> known_parts(const ExpectedRawlog& expected) {
    std::set<std::string> parts;
    for (const auto& [name, figure] : expected.figures) parts.insert(part_of(name));
    return parts;
}

std::optional<Deviation> check_figure(const std::string& id, const std::string& name,
                                      const ExpectedFigure& expected, const Figures& figures) {
    const auto found = figures.find(name);
    if (found == figures.end())
        return Deviation{id, name, "expected " + value_text(expected.value) + ", is not there"};
    const std::optional<double>& is = found->second;
    if (is.has_value() != expected.value.has_value())
        return Deviation{id, name, "expected " + value_text(expected.value) + ", is " + value_text(is)};
    if (!is) return std::nullopt;
    const double width = expected.tolerance.width(*expected.value);
    if (std::abs(*is - *expected.value) <= width) return std::nullopt;
    return Deviation{
        id, name,
        change_text(name, *expected.value, *is) + "; allowed " + tolerance_text(expected.tolerance)};
}

void check_rawlog(const ExpectedRawlog& expected, const RawlogResult& rawlog,
                  std::vector<Deviation>& deviations) {
    if (rawlog.outcome == Outcome::Missing) {
        deviations.push_back({rawlog.id, "", "no result: it has not been replayed"});
        return;
    }
    if (rawlog.result.status != expected.status) {
        const std::string why = rawlog.result.reason.empty() ? "" : " (" + rawlog.result.reason + ")";
        deviations.push_back({rawlog.id, "",
                              "exit status of the replay: expected " + status_text(expected.status) +
                                  ", is " + status_text(rawlog.result.status) + why});
    }
    for (const auto& [name, figure] : expected.figures)
        if (const auto deviation = check_figure(rawlog.id, name, figure, rawlog.result.figures))
            deviations.push_back(*deviation);
    const std::set<std::string> parts = known_parts(expected);
    for (const auto& [name, value] : rawlog.result.figures)
        if (expected.figures.count(name) == 0 && parts.count(part_of(name)) == 1)
            deviations.push_back({rawlog.id, name, "is " + value_text(value) + ", was not there before"});
}

ExpectedRawlog accepted(const ExpectedRawlog& before, const Result& result) {
    ExpectedRawlog after;
    after.status = result.status;
    for (const auto& [name, value] : result.figures) {
        const auto known = before.figures.find(name);
        const bool keep = known != before.figures.end() && known->second.value && value;
        after.figures[name] = {value, keep    ? known->second.tolerance
                                      : value ? figure_rule(name, *value).tolerance
                                              : Tolerance{}};
    }
    return after;
}

void difference_of(const std::string& id, const ExpectedRawlog& before, const ExpectedRawlog& after,
                   std::vector<std::string>& lines) {
    if (before.status != after.status)
        lines.push_back(id + ": exit status " + status_text(before.status) + " -> " +
                        status_text(after.status));
    for (const auto& [name, figure] : after.figures) {
        const auto old = before.figures.find(name);
        if (old == before.figures.end()) {
            lines.push_back(id + ": " + name + ": new, " + value_text(figure.value));
        } else if (old->second.value != figure.value) {
            const bool numbers = old->second.value && figure.value;
            lines.push_back(id + ": " + name + ": " +
                            (numbers ? change_text(name, *old->second.value, *figure.value)
                                     : value_text(old->second.value) + " -> " + value_text(figure.value)));
        }
    }
    for (const auto& [name, figure] : before.figures)
        if (after.figures.count(name) == 0) lines.push_back(id + ": " + name + ": gone");
}

}  // namespace

std::vector<Deviation> check(const Expectation& expectation, const RunResults& results) {
    std::vector<Deviation> deviations;
    std::set<std::string> seen;
    for (const RawlogResult& rawlog : results) {
        seen.insert(rawlog.id);
        const auto expected = expectation.rawlogs.find(rawlog.id);
        if (expected == expectation.rawlogs.end()) {
            deviations.push_back(
                {rawlog.id, "", "nothing is expected of it yet: see flownav-regress accept"});
        } else {
            check_rawlog(expected->second, rawlog, deviations);
        }
    }
    for (const auto& [id, expected] : expectation.rawlogs)
        if (seen.count(id) == 0) deviations.push_back({id, "", "is expected, but not in the manifest"});
    return deviations;
}

std::set<std::string> unchecked_parts(const Expectation& expectation, const RunResults& results) {
    std::set<std::string> unchecked;
    for (const RawlogResult& rawlog : results) {
        const auto expected = expectation.rawlogs.find(rawlog.id);
        if (expected == expectation.rawlogs.end()) continue;
        const std::set<std::string> known = known_parts(expected->second);
        for (const auto& [name, value] : rawlog.result.figures)
            if (known.count(part_of(name)) == 0) unchecked.insert(part_of(name));
    }
    return unchecked;
}

Expectation accept(const Expectation& before, const RunResults& results) {
    Expectation after;
    after.replayed_by = program_of(results);
    for (const RawlogResult& rawlog : results) {
        const auto known = before.rawlogs.find(rawlog.id);
        const bool is_known = known != before.rawlogs.end();
        if (rawlog.outcome != Outcome::Missing) {
            after.rawlogs[rawlog.id] = accepted(is_known ? known->second : ExpectedRawlog{}, rawlog.result);
        } else if (is_known) {
            after.rawlogs[rawlog.id] = known->second;
        }
    }
    return after;
}

std::vector<std::string> difference(const Expectation& before, const Expectation& after) {
    std::vector<std::string> lines;
    if (before.replayed_by != after.replayed_by)
        lines.push_back("replayed by: '" + before.replayed_by + "' -> '" + after.replayed_by + "'");
    for (const auto& [id, rawlog] : after.rawlogs) {
        const auto old = before.rawlogs.find(id);
        if (old == before.rawlogs.end()) {
            lines.push_back(id + ": new, " + std::to_string(rawlog.figures.size()) + " figures");
        } else {
            difference_of(id, old->second, rawlog, lines);
        }
    }
    for (const auto& [id, rawlog] : before.rawlogs)
        if (after.rawlogs.count(id) == 0) lines.push_back(id + ": gone");
    return lines;
}

}  // namespace flownav::regress
