#include "image_names.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "written_time.h"

namespace flownav::io {
namespace {

/// A name as runs of digits and the text around them; text has one entry more than runs.
struct Parts {
    std::vector<std::string> text;
    std::vector<std::string> runs;
};

Parts parts_of(const std::string& stem) {
    Parts parts;
    parts.text.emplace_back();
    bool in_digits = false;
    for (const char c : stem) {
        const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
        if (digit && !in_digits) parts.runs.emplace_back();
        if (!digit && in_digits) parts.text.emplace_back();
        (digit ? parts.runs : parts.text).back() += c;
        in_digits = digit;
    }
    if (in_digits) parts.text.emplace_back();
    return parts;
}

using Names = std::vector<Parts>;

bool same_text(const Names& names) {
    return std::all_of(names.begin(), names.end(),
                       [&](const Parts& parts) { return parts.text == names.front().text; });
}

std::vector<std::size_t> changing_runs(const Names& names) {
    std::vector<std::size_t> changing;
    for (std::size_t run = 0; run < names.front().runs.size(); ++run) {
        const auto differs = [&](const Parts& parts) { return parts.runs[run] != names.front().runs[run]; };
        if (std::any_of(names.begin(), names.end(), differs)) changing.push_back(run);
    }
    return changing;
}

bool short_runs(const Names& names, std::size_t run) {
    return std::all_of(names.begin(), names.end(), [&](const Parts& parts) {
        return !parts.runs[run].empty() && parts.runs[run].size() <= 19;
    });
}

template <class Value>
bool rising(const std::vector<Value>& values) {
    for (std::size_t i = 1; i < values.size(); ++i)
        if (!(values[i] > values[i - 1])) return false;
    return true;
}

std::vector<long double> values_of(const Names& names, std::size_t run) {
    std::vector<long double> values;
    for (const Parts& parts : names) values.push_back(std::stold(parts.runs[run]));
    return values;
}

/// Times in seconds of written times of names; empty when they are none.
std::vector<double> stamps_of(const std::vector<long double>& values, std::optional<TimeUnit> asked,
                              std::vector<std::string>& notes) {
    const UnitFinding finding = find_time_unit(values, {asked, std::nullopt});
    if (!finding.unit) return {};
    const long double per_second = std::llround(1.0 / seconds_of(*finding.unit));
    std::vector<double> stamps_s;
    for (const long double value : values) stamps_s.push_back(static_cast<double>(value / per_second));
    if (!rising(stamps_s) || stamps_s.back() > latest_time_s) return {};
    notes.push_back(std::string("the names of the images are times in ") + name_of(*finding.unit) +
                    (stamps_s.front() > 1e8 ? ", the first is " + date_text(stamps_s.front()) + " UTC" : ""));
    return stamps_s;
}

/// Numbers large enough to be times since 2000 in seconds.
bool since_1970(const std::vector<long double>& values) {
    constexpr long double year_2000_s = 946684800.0L;
    return std::all_of(values.begin(), values.end(), [](long double v) { return v >= year_2000_s; });
}

/// Seconds and their fraction, such as 1305031102.175304 and 1403636579_763555584; a fraction after another
/// sign than a point counts nanoseconds, or has as many digits in each name.
std::vector<long double> seconds_and_fraction(const Names& names, std::size_t run) {
    const std::string& between = names.front().text[run + 1];
    if (between != "." && between != "_" && between != "-") return {};
    std::size_t longest = 0;
    std::size_t shortest = 20;
    for (const Parts& parts : names) {
        longest = std::max(longest, parts.runs[run + 1].size());
        shortest = std::min(shortest, parts.runs[run + 1].size());
    }
    const bool usual = longest == 9 || (shortest == longest && (longest == 3 || longest == 6));
    if (between != "." && !usual) return {};
    std::vector<long double> values;
    for (const Parts& parts : names) {
        const std::string& fraction = parts.runs[run + 1];
        const std::size_t zeros = between == "." ? 0 : longest - fraction.size();
        values.push_back(std::stold(parts.runs[run] + "." + std::string(zeros, '0') + fraction));
    }
    return values;
}

/// Dates such as 20110926_130225_964 or 2011-09-26T13-02-25.964, beginning at `run`.
std::vector<long double> dates(const Names& names, std::size_t run) {
    std::vector<long double> values;
    for (const Parts& parts : names) {
        std::string digits;
        std::size_t next = run;
        while (next < parts.runs.size() && digits.size() < 14) digits += parts.runs[next++];
        if (digits.size() != 14 && digits.size() != 17) return {};
        std::string text = digits.substr(0, 8) + "T" + digits.substr(8, 6) + "." + digits.substr(14);
        if (digits.size() == 14 && next < parts.runs.size()) text += parts.runs[next];
        const auto time = parse_written_time(text);
        if (!time || !time->date || time->value < 946684800.0L) return {};
        values.push_back(time->value);
    }
    return values;
}

/// Times in names with a constant text around their numbers; empty when there are none.
std::vector<double> find_stamps(const Names& names, const std::vector<std::size_t>& changing,
                                std::optional<TimeUnit> unit, std::vector<std::string>& notes) {
    const std::size_t runs = names.front().runs.size();
    if (unit && *unit != TimeUnit::Seconds) return stamps_of(values_of(names, changing.back()), unit, notes);
    for (std::size_t run = 0; run < runs; ++run) {
        if (const auto values = dates(names, run); !values.empty() && rising(values))
            return stamps_of(values, TimeUnit::Seconds, notes);
        if (run + 1 == runs) break;
        const bool changes = std::find(changing.begin(), changing.end(), run + 1) != changing.end();
        if (!changes || !short_runs(names, run) || !short_runs(names, run + 1)) continue;
        const auto values = seconds_and_fraction(names, run);
        const bool point = names.front().text[run + 1] == "." && names.front().runs[run + 1].size() >= 2;
        if (!values.empty() && rising(values) && (point || since_1970(values)))
            return stamps_of(values, TimeUnit::Seconds, notes);
    }
    if (unit) return stamps_of(values_of(names, changing.back()), unit, notes);
    for (const std::size_t run : changing) {
        const auto values = values_of(names, run);
        if (!rising(values) || !since_1970(values)) continue;
        auto stamps_s = stamps_of(values, std::nullopt, notes);
        if (!stamps_s.empty()) return stamps_s;
    }
    return {};
}

/// Describes names of two cameras in one folder; empty when there are none.
std::string two_series(const Names& names) {
    std::map<std::vector<std::string>, std::set<std::vector<std::string>>> series;
    for (const Parts& parts : names) series[parts.text].insert(parts.runs);
    if (series.size() < 2) return "";
    const auto& first = *series.begin();
    const auto& second = *std::next(series.begin());
    const bool overlap = std::any_of(first.second.begin(), first.second.end(),
                                     [&](const auto& runs) { return second.second.count(runs) > 0; });
    if (first.second.size() < 2 || second.second.size() < 2 || !overlap) return "";
    return "holds the same numbers under two names ('" + first.first.front() + "...' and '" +
           second.first.front() +
           "...'): images of two cameras, or copies; put those of one camera into a folder of their own";
}

/// Why rising numbers do not count images; empty when they do.
std::string why_no_counter(const std::vector<std::size_t>& numbers) {
    const std::size_t step = usual_step(numbers);
    std::size_t usual = 0;
    bool multiples = true;
    for (std::size_t i = 1; i < numbers.size(); ++i) {
        const std::size_t difference = numbers[i] - numbers[i - 1];
        usual += difference == step ? 1 : 0;
        multiples = multiples && difference % step == 0;
    }
    if (multiples && 2 * usual + 1 >= numbers.size()) return "";
    return "the numbers in the names of the images rise irregularly, most often by " + std::to_string(step) +
           ": if they are times, tell the unit with --times-unit s|ms|us|ns; else give --times with the "
           "names "
           "of the images";
}

/// The changing run that counts the images: the only one, else the first that rises; empty when none does.
std::optional<std::size_t> counter_run(const Names& names, const std::vector<std::size_t>& changing) {
    if (changing.size() == 1) return changing.front();
    for (const std::size_t run : changing)
        if (rising(values_of(names, run))) return run;
    return std::nullopt;
}

/// True when a number of the last changing run comes twice.
bool last_run_repeats(const Names& names, const std::vector<std::size_t>& changing) {
    const auto values = values_of(names, changing.back());
    return std::set<long double>(values.begin(), values.end()).size() < values.size();
}

void find_numbers(const Names& names, const std::vector<std::size_t>& changing, NameSeries& series) {
    const auto run = counter_run(names, changing);
    if (!run && last_run_repeats(names, changing)) {
        series.refusal =
            "the names of the images hold several numbers that change, and the last one repeats: images of "
            "two cameras or drives; put those of one into a folder of their own, or give --times with the "
            "names of the images";
        return;
    }
    if (!run) {
        series.notes.emplace_back(
            "the names of the images hold several numbers that change; the images are taken in the order of "
            "their names");
        return;
    }
    for (const Parts& parts : names) {
        if (parts.runs[*run].size() > 18) return;
        series.numbers.push_back(std::stoull(parts.runs[*run]));
    }
    if (!rising(series.numbers)) {
        series.numbers.clear();
        series.refusal =
            "two images have the same number (in another number of digits, or with another ending): remove "
            "one of them";
        return;
    }
    series.no_counter = why_no_counter(series.numbers);
    if (!series.no_counter.empty()) series.numbers.clear();
}

}  // namespace

NameSeries read_names(const std::vector<std::string>& stems, std::optional<TimeUnit> unit) {
    NameSeries series;
    Names names;
    for (const std::string& stem : stems) names.push_back(parts_of(stem));
    series.refusal = two_series(names);
    if (!series.refusal.empty() || !same_text(names)) return series;
    const auto changing = changing_runs(names);
    if (changing.empty()) {
        if (names.size() > 1)
            series.refusal = "two images have the same name and different endings: remove one";
        return series;
    }
    for (const std::size_t run : changing)
        if (!short_runs(names, run)) return series;
    series.stamps_s = find_stamps(names, changing, unit, series.notes);
    if (series.stamps_s.empty() && unit) {
        series.refusal = std::string("the names of the images are no rising times in ") + name_of(*unit);
    } else if (series.stamps_s.empty()) {
        find_numbers(names, changing, series);
    }
    return series;
}

std::size_t usual_step(const std::vector<std::size_t>& numbers) {
    std::map<std::size_t, std::size_t> counts;
    for (std::size_t i = 1; i < numbers.size(); ++i) ++counts[numbers[i] - numbers[i - 1]];
    std::size_t step = 1;
    std::size_t most = 0;
    for (const auto& [difference, count] : counts) {
        if (count > most) step = difference;
        most = std::max(most, count);
    }
    return step;
}

}  // namespace flownav::io
