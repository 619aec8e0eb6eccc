#include "list_matching.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "flownav/io/errors.h"
#include "image_names.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;
using Images = std::vector<fs::path>;

std::string count_of(std::size_t count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Tells of rows whose images are not there.
void tell_missing_images(const TimesList& list, std::size_t missing, std::size_t first_line,
                         ImageSchedule& schedule) {
    if (missing == 0) return;
    schedule.problems.push_back(list.file.string() + ": " + std::to_string(missing) + " of its " +
                                count_of(list.rows.size(), "time") + " have no image, the first in line " +
                                std::to_string(first_line) + "; all other images keep their times");
}

/// Sorts by time; leaves out images whose time an earlier one has.
void sort_by_time(const TimesList& list, ImageSchedule& schedule) {
    const auto earlier = [](const TimedImage& a, const TimedImage& b) { return a.time_s < b.time_s; };
    auto& images = schedule.images;
    if (!std::is_sorted(images.begin(), images.end(), earlier)) {
        std::stable_sort(images.begin(), images.end(), earlier);
        schedule.notes.push_back(
            list.file.string() +
            ": the times do not rise in the order of its rows; the images are taken in the "
            "order of their times");
    }
    for (std::size_t i = 1; i < images.size();) {
        if (images[i].time_s > images[i - 1].time_s) {
            ++i;
            continue;
        }
        schedule.problems.push_back(images[i].file.string() + ": has the same time as " +
                                    images[i - 1].file.filename().string() + " and is left out");
        images.erase(images.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

/// Matches by the names in the list.
void match_names(const TimesList& list, const Images& images, ImageSchedule& schedule) {
    std::map<std::string, std::pair<fs::path, bool>> by_stem;
    for (const fs::path& image : images) by_stem[image.stem().string()] = {image, false};
    if (by_stem.size() != images.size())
        throw InputError(images.front().parent_path().string() +
                         ": two images have the same name and different endings: remove one");
    std::size_t missing = 0;
    std::size_t first_missing_line = 0;
    for (const TimesRow& row : list.rows) {
        const auto found = by_stem.find(row.image);
        if (found == by_stem.end()) {
            if (missing++ == 0) first_missing_line = row.line;
            continue;
        }
        if (found->second.second)
            throw InputError(list.file.string() + ", line " + std::to_string(row.line) + ": names " +
                             row.image + " a second time");
        found->second.second = true;
        schedule.images.push_back({found->second.first, row.time_s});
    }
    if (schedule.images.empty())
        throw InputError(list.file.string() + ": names none of the images (they are named as " +
                         images.front().filename().string() + "); use --rate, or another --times");
    for (const auto& [stem, image] : by_stem)
        if (!image.second)
            schedule.problems.push_back(image.first.string() + ": is left out, " +
                                        list.file.filename().string() + " has no time for it");
    tell_missing_images(list, missing, first_missing_line, schedule);
    sort_by_time(list, schedule);
}

/// Matches numbers of images with numbers of rows; `row_number` numbers the rows from first to last.
template <class Number>
void match_numbers(const TimesList& list, const Images& images, const std::vector<std::size_t>& numbers,
                   Number row_number, ImageSchedule& schedule) {
    std::map<std::size_t, std::size_t> image_of;
    for (std::size_t i = 0; i < numbers.size(); ++i) image_of[numbers[i]] = i;
    std::size_t missing = 0;
    std::size_t first_missing_line = 0;
    std::vector<bool> timed(images.size(), false);
    for (std::size_t row = 0; row < list.rows.size(); ++row) {
        const auto found = image_of.find(row_number(row));
        if (found == image_of.end()) {
            if (missing++ == 0) first_missing_line = list.rows[row].line;
            continue;
        }
        timed[found->second] = true;
        schedule.images.push_back({images[found->second], list.rows[row].time_s});
    }
    for (std::size_t i = 0; i < images.size(); ++i)
        if (!timed[i])
            schedule.problems.push_back(images[i].string() + ": is left out, " +
                                        list.file.filename().string() + " has no time for its number");
    tell_missing_images(list, missing, first_missing_line, schedule);
}

/// Gives each image the time of the row in the same place.
void match_order(const TimesList& list, const Images& images, ImageSchedule& schedule) {
    for (std::size_t i = 0; i < images.size(); ++i)
        schedule.images.push_back({images[i], list.rows[i].time_s});
}

/// True when the times pause where the numbers have gaps, within a factor of two.
bool pauses_match_gaps(const TimesList& list, const std::vector<std::size_t>& numbers) {
    if (numbers.size() < 2) return true;
    const std::size_t step = usual_step(numbers);
    std::vector<double> usual;
    for (std::size_t i = 1; i < numbers.size(); ++i)
        if (numbers[i] - numbers[i - 1] == step)
            usual.push_back(list.rows[i].time_s - list.rows[i - 1].time_s);
    std::sort(usual.begin(), usual.end());
    const double period_s = usual[usual.size() / 2];
    for (std::size_t i = 1; i < numbers.size(); ++i) {
        const double steps = static_cast<double>(numbers[i] - numbers[i - 1]) / static_cast<double>(step);
        const double pause_s = list.rows[i].time_s - list.rows[i - 1].time_s;
        if (steps >= 2 && (pause_s < 0.6 * steps * period_s || pause_s > 2.5 * steps * period_s))
            return false;
    }
    return true;
}

[[noreturn]] void refuse_counts(const TimesList& list, const Images& images, const std::string& why) {
    throw InputError(list.file.string() + ": holds " + count_of(list.rows.size(), "time") + " for " +
                     count_of(images.size(), "image") + why +
                     "; name the images in a column of the list, or use --rate, or another --times");
}

bool steady(const TimesList& list) {
    if (list.rows.size() < 2) return true;
    const double mean_s =
        (list.rows.back().time_s - list.rows.front().time_s) / static_cast<double>(list.rows.size() - 1);
    for (std::size_t i = 1; i < list.rows.size(); ++i) {
        const double period_s = list.rows[i].time_s - list.rows[i - 1].time_s;
        if (std::abs(period_s - mean_s) > 0.02 * mean_s) return false;
    }
    return true;
}

/// Matches more rows than images by the numbers in the names of the images: rows count from 0, or from 1.
void match_more_rows(const TimesList& list, const Images& images, const NameSeries& names,
                     ImageSchedule& schedule) {
    const std::size_t rows = list.rows.size();
    const auto& numbers = names.numbers;
    if (numbers.empty()) refuse_counts(list, images, ", whose names have no numbers");
    const bool from_0 = numbers.back() < rows;
    const bool from_1 = numbers.front() >= 1 && numbers.back() == rows;
    if (!from_0 && !from_1)
        refuse_counts(list, images,
                      ", which are numbered " + std::to_string(numbers.front()) + " to " +
                          std::to_string(numbers.back()));
    if (from_0 && numbers.front() > 0 && !steady(list))
        refuse_counts(list, images, ", and it is not known whether its rows count from 0 or from 1");
    const std::size_t first = from_0 ? 0 : 1;
    match_numbers(
        list, images, numbers, [first](std::size_t row) { return row + first; }, schedule);
    schedule.notes.push_back(list.file.string() +
                             ": the images have their times by the numbers in their names; number " +
                             std::to_string(first) + " has the first time");
}

/// Matches by the times in the names; empty schedule when the list holds other times.
void match_stamps(const TimesList& list, const Images& images, const NameSeries& names,
                  ImageSchedule& schedule) {
    std::map<std::int64_t, std::size_t> image_of;
    const auto key = [](double time_s) { return std::llround(time_s * 1e4); };
    for (std::size_t i = 0; i < images.size(); ++i) image_of[key(names.stamps_s[i])] = i;
    ImageSchedule matched;
    std::size_t first_missing_line = 0;
    for (const TimesRow& row : list.rows) {
        auto found = image_of.find(key(row.time_s));
        for (const int near : {-1, 1})
            if (found == image_of.end()) found = image_of.find(key(row.time_s) + near);
        if (found != image_of.end()) {
            matched.images.push_back({images[found->second], row.time_s});
        } else if (first_missing_line == 0) {
            first_missing_line = row.line;
        }
    }
    if (matched.images.size() != images.size()) return;
    tell_missing_images(list, list.rows.size() - images.size(), first_missing_line, schedule);
    schedule.images = matched.images;
}

/// Throws unless times and names tell the same distances of images.
void require_same_distances(const TimesList& list, const Images& images, const NameSeries& names) {
    for (std::size_t i = 1; i < images.size(); ++i) {
        const double by_name_s = names.stamps_s[i] - names.stamps_s[i - 1];
        const double by_list_s = list.rows[i].time_s - list.rows[i - 1].time_s;
        if (std::abs(by_name_s - by_list_s) <= 0.002 + 0.02 * by_name_s) continue;
        throw InputError(list.file.string() + ", line " + std::to_string(list.rows[i].line) +
                         ": tells another time than the name of " + images[i].filename().string() +
                         "; move the list away to use the names, or give --times with names of the images");
    }
}

void match_unnamed(const TimesList& list, const Images& images, ImageSchedule& schedule) {
    const NameSeries names = read_names(stems_of(images), std::nullopt);
    if (!names.refusal.empty())
        throw InputError(images.front().parent_path().string() + ": " + names.refusal);
    if (list.has_numbers && !names.numbers.empty()) {
        const auto number = [&list](std::size_t row) { return list.rows[row].number.value_or(0); };
        match_numbers(list, images, names.numbers, number, schedule);
        if (!schedule.images.empty() && 2 * schedule.images.size() >= images.size())
            return sort_by_time(list, schedule);
        schedule.images.clear();
        schedule.problems.clear();
    }
    require_rising(list);
    if (!names.stamps_s.empty()) {
        match_stamps(list, images, names, schedule);
        if (!schedule.images.empty()) return;
        if (list.rows.size() == images.size()) require_same_distances(list, images, names);
    }
    if (list.rows.size() < images.size()) refuse_counts(list, images, "");
    if (list.rows.size() > images.size()) return match_more_rows(list, images, names, schedule);
    if (!names.numbers.empty() && !pauses_match_gaps(list, names.numbers)) {
        throw InputError(
            list.file.string() +
            ": has as many times as there are images, but the numbers of the images have gaps where "
            "the times have none; name the images in a column of the list, or use --rate");
    }
    match_order(list, images, schedule);
}

}  // namespace

std::vector<std::string> stems_of(const Images& images) {
    std::vector<std::string> stems;
    for (const fs::path& image : images) stems.push_back(image.stem().string());
    return stems;
}

void match_list(const TimesList& list, const Images& images, ImageSchedule& schedule) {
    if (list.has_names) {
        match_names(list, images, schedule);
    } else {
        match_unnamed(list, images, schedule);
    }
}

}  // namespace flownav::io
