#include "image_times.h"

#include <algorithm>
#include <sstream>

#include "flownav/io/errors.h"
#include "image_names.h"
#include "list_matching.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;
using Images = std::vector<fs::path>;

/// File with times in the folder or its parent; empty when there is none. Lists that name their images count
/// only when they name some of these.
fs::path find_times_file(const fs::path& directory, const std::vector<std::string>& stems) {
    const fs::path inside = fs::weakly_canonical(directory / "");
    const fs::path folder_itself = inside.has_filename() ? inside : inside.parent_path();
    for (const fs::path& folder : {folder_itself, folder_itself.parent_path()}) {
        for (const char* name : {"times.txt", "log.csv", "timestamps.txt"})
            if (fs::is_regular_file(folder / name)) return folder / name;
        for (const std::string& name :
             {std::string("data.csv"), std::string("rgb.txt"), folder_itself.filename().string() + ".txt"}) {
            if (!fs::is_regular_file(folder / name)) continue;
            try {
                const TimesList list = read_times_list(folder / name, std::nullopt, stems);
                const bool known = std::any_of(list.rows.begin(), list.rows.end(), [&](const TimesRow& row) {
                    return std::find(stems.begin(), stems.end(), row.image) != stems.end();
                });
                if (known) return folder / name;
            } catch (const InputError&) {
                continue;  // another kind of file with this name
            }
        }
    }
    return {};
}

void take_gyro(const TimesList& list, ImageSchedule& schedule) {
    for (std::size_t i = 0; i + 1 < list.rows.size(); ++i) {
        const TimesRow& row = list.rows[i];
        if (!row.gyro_z_radps || !(list.rows[i + 1].time_s > row.time_s)) continue;
        schedule.gyro.push_back({0.5 * (row.time_s + list.rows[i + 1].time_s), *row.gyro_z_radps});
    }
}

void times_from_list(const fs::path& file, const Images& images, const FrameTimes& times,
                     ImageSchedule& schedule) {
    const TimesList list = read_times_list(file, times.unit, stems_of(images));
    schedule.notes = list.notes;
    schedule.source = file.string();
    match_list(list, images, schedule);
    take_gyro(list, schedule);
}

void times_from_rate(const Images& images, double rate_hz, const NameSeries& names, ImageSchedule& schedule) {
    const std::size_t step = usual_step(names.numbers);
    for (std::size_t i = 0; i < images.size(); ++i) {
        const double count =
            names.numbers.empty()
                ? static_cast<double>(i)
                : static_cast<double>(names.numbers[i] - names.numbers[0]) / static_cast<double>(step);
        schedule.images.push_back({images[i], count / rate_hz});
    }
    std::ostringstream text;
    text << rate_hz << " images a second";
    schedule.source = text.str();
    if (names.numbers.empty()) return;
    if (step > 1)
        schedule.notes.push_back("the numbers of the images rise by " + std::to_string(step) +
                                 "; the rate is taken as that of these images");
    const std::size_t places = (names.numbers.back() - names.numbers.front()) / step + 1;
    if (places > images.size())
        schedule.problems.push_back(std::to_string(places - images.size()) + " of " + std::to_string(places) +
                                    " numbers from " + std::to_string(names.numbers.front()) + " to " +
                                    std::to_string(names.numbers.back()) +
                                    " have no image; all other images keep the times of their numbers");
}

/// Median of the distances of the images.
double period_of(const std::vector<TimedImage>& images) {
    std::vector<double> periods_s;
    for (std::size_t i = 1; i < images.size(); ++i)
        periods_s.push_back(images[i].time_s - images[i - 1].time_s);
    const auto middle = periods_s.begin() + static_cast<std::ptrdiff_t>((periods_s.size() - 1) / 2);
    std::nth_element(periods_s.begin(), middle, periods_s.end());
    return *middle;
}

/// Tells of images that are far apart, always or here and there.
void tell_pauses(ImageSchedule& schedule) {
    constexpr double bridged_s = 0.5;
    constexpr double long_s = 10.0;
    const auto& images = schedule.images;
    if (images.size() < 2) return;
    const double period_s = period_of(images);
    std::ostringstream text;
    if (period_s > bridged_s) {
        text << "the images are " << period_s
             << " s apart: a replay needs motion.gap_max_s above that (default " << bridged_s << ")";
        schedule.notes.push_back(text.str());
    }
    for (std::size_t i = 1; i < images.size(); ++i) {
        const double pause_s = images[i].time_s - images[i - 1].time_s;
        if (pause_s < std::max(long_s, 20 * period_s)) continue;
        std::ostringstream pause;
        pause << images[i].file.filename().string() << ": comes " << pause_s
              << " s after the image before; correct its time if the camera did not pause";
        schedule.notes.push_back(pause.str());
    }
}

}  // namespace

ImageSchedule schedule_images(const fs::path& directory, const Images& images, const FrameTimes& times) {
    ImageSchedule schedule;
    fs::path file = times.file;
    if (file.empty() && !times.rate_hz) file = find_times_file(directory, stems_of(images));
    if (!file.empty()) {
        times_from_list(file, images, times, schedule);
    } else {
        const NameSeries names = read_names(stems_of(images), times.rate_hz ? std::nullopt : times.unit);
        for (const std::string& why : {names.refusal, names.no_counter})
            if (!why.empty()) throw InputError(directory.string() + ": " + why);
        if (names.stamps_s.empty() || !times.rate_hz) schedule.notes = names.notes;
        if (!names.stamps_s.empty() && times.rate_hz)
            schedule.notes.emplace_back("the names of the images are times; --rate is used instead of them");
        if (!names.stamps_s.empty() && !times.rate_hz) {
            for (std::size_t i = 0; i < images.size(); ++i)
                schedule.images.push_back({images[i], names.stamps_s[i]});
            schedule.source = "the names of the images";
        } else {
            times_from_rate(images, times.rate_hz.value_or(times.default_rate_hz), names, schedule);
            if (!times.rate_hz)
                schedule.notes.push_back(directory.string() + ": has no times; " + schedule.source +
                                         " are assumed, give --rate or --times when that is wrong");
        }
    }
    tell_pauses(schedule);
    return schedule;
}

}  // namespace flownav::io
