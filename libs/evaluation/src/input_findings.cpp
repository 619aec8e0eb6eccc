#include <algorithm>
#include <array>
#include <cmath>

#include "finding_text.h"
#include "flownav/evaluation/findings.h"
#include "flownav/io/event_times.h"

namespace flownav::evaluation {
namespace {

constexpr double pause_told_s = 600.0;  // a longer pause may be a clock that was set ahead

/// A reason for which data are left out, or used nevertheless.
struct Reason {
    const char* name;
    const char* words;   ///< what is wrong with them, behind "13 of 15 images"
    const char* advice;  ///< what to do
    bool always_told = false;
};

constexpr Reason left_out[] = {
    {"time_invalid", "have no valid time stamp", "record a time with each"},
    {"time_out_of_range", "have time stamps before 1970 or after 2100",
     "record seconds since 1970, and check the unit of the stamps"},
    {"time_repeated", "have the time stamp of the one before",
     "record stamps finer than the interval; images without times get them by flownav-import images --rate"},
    {"time_backwards", "have stamps before those of the ones that came earlier", "record in order of time"},
    {"time_ahead", "have stamps far from those before and after them", "check the clock of the recorder",
     true},
    {"time_too_close", "have stamps that nearly equal those of a neighbour",
     "stamp when the sensor exposes, not when a pair arrives"},
    {"time_uneven", "have stamps off the beat of the others", "stamp when the sensor exposes"},
    {"image_missing", "are files that are not where the recording says",
     "keep the folder of images beside the rawlog"},
    {"image_unreadable", "are files that cannot be read as pictures", "record or copy them again"},
    {"image_empty", "hold no picture", "check the camera's driver"},
    {"image_not_8bit", "have pixels of more than 8 bits", "record 8-bit grey or colour images"},
    {"not_finite", "hold a number that is none", "check what wrote them"},
};

constexpr Reason used_nevertheless[] = {
    {"time_irregular", "have stamps far closer to the one before than usual",
     "speeds of single fields are not reliable; stamp when the sensor exposes"},
    {"calibration_scaled", "have a calibration for another image size of the same shape, which was scaled",
     "record the calibration of this size, or set camera.fx_px, fy_px, cx_px and cy_px", true},
    {"pose_x_forward", "have a cameraPose with the axes of the robot (x forward), which was converted",
     "record the pose of the optical axes (x right, y down, z forward), or set camera.height_m and "
     "camera.pitch_deg",
     true},
    {"principal_point_off_centre", "have a principal point far from the middle of the image",
     "is the calibration for another image size? Set camera.fx_px, fy_px, cx_px and cy_px of this one", true},
    {"image_size_changed", "have another size than the one before, and sensing began anew",
     "record one size, or split the recording"},
    {"calibration_changed", "have another calibration or pose than the one before, and sensing began anew",
     "record one calibration, or set the keys of [camera]"},
};

/// A sensor's observations, and how sentences call them.
struct Stream {
    io::EventKind kind;
    const char* things;
    std::uint64_t used;
};

std::uint64_t count_of(const std::map<std::string, std::uint64_t>& counts, const std::string& name) {
    const auto found = counts.find(name);
    return found == counts.end() ? 0 : found->second;
}

/// All observations of a stream, used or left out.
std::uint64_t total(const io::InputCounts& read, const Stream& stream) {
    if (stream.kind == io::EventKind::Image) return read.images;
    std::uint64_t sum = stream.used;
    for (const Reason& reason : left_out)
        sum += count_of(read.rejected, io::prefix_of(stream.kind) + std::string(reason.name));
    return sum;
}

bool is_told(const Reason& reason, std::uint64_t count, std::uint64_t of) {
    return count > 0 &&
           (reason.always_told || static_cast<double>(count) > told_share * static_cast<double>(of));
}

/// True when the stamps of nearly all images are whole seconds.
bool has_whole_seconds(const io::InputCounts& read) {
    constexpr double nearly_all = 0.9;
    const auto found = read.details.find("images_at_whole_seconds");
    return found != read.details.end() && found->second >= nearly_all * static_cast<double>(read.images);
}

void judge_counts(const io::InputCounts& read, const Stream& stream, std::vector<Finding>& findings) {
    const std::string prefix = io::prefix_of(stream.kind);
    const std::uint64_t of = total(read, stream);
    for (const Reason& reason : left_out) {
        const std::uint64_t count = count_of(read.rejected, prefix + reason.name);
        if (!is_told(reason, count, of)) continue;
        std::string words = reason.words;
        if (prefix.empty() && words == left_out[2].words && has_whole_seconds(read))
            words += ", since all stamps are whole seconds";
        findings.push_back({prefix + reason.name,
                            counted(count, of, stream.things) + ' ' + words +
                                " and were left out: " + reason.advice + findings_page,
                            static_cast<double>(count) > told_share * static_cast<double>(of)});
    }
    for (const Reason& reason : used_nevertheless) {
        const std::uint64_t count = count_of(read.warnings, prefix + reason.name);
        if (!is_told(reason, count, of)) continue;
        findings.push_back({prefix + reason.name, counted(count, of, stream.things) + ' ' + reason.words +
                                                      ": " + reason.advice + findings_page});
    }
}

void judge_clock(const io::InputCounts& read, const Stream& stream, std::vector<Finding>& findings) {
    const std::string prefix = io::prefix_of(stream.kind);
    const auto seconds = [&read](const std::string& name) {
        const auto found = read.details.find(name);
        return found == read.details.end() ? 0.0 : found->second;
    };
    const std::string back = prefix + "clock_set_back", jump = prefix + "clock_jump";
    if (const auto count = count_of(read.warnings, back)) {
        findings.push_back({back, "the clock of the " + std::string(stream.things) + " was set back " +
                                      std::to_string(count) + (count == 1 ? " time" : " times") +
                                      ", by up to " + cli::fixed_text(seconds(back + "_s"), 2) +
                                      " s: the times behind it were shifted so that they go on, and nothing "
                                      "was left out; set clocks before a recording, and join files in order" +
                                      findings_page});
    }
    if (seconds(jump + "_s") > pause_told_s) {
        findings.push_back({jump, "the times of the " + std::string(stream.things) + " jump ahead by " +
                                      cli::fixed_text(seconds(jump + "_s"), 0) +
                                      " s: a pause, or a clock that was set; the way during it is not known" +
                                      findings_page});
    }
}

/// Labels of all observations of a class, without the results of flownav itself, with their counts.
std::map<std::string, std::uint64_t> labels_of(const io::InputCounts& read, const std::string& class_name) {
    std::map<std::string, std::uint64_t> labels;
    for (const auto& [name, count] : read.observations) {
        if (name.rfind(class_name + ' ', 0) != 0) continue;
        const std::string label = name.substr(class_name.size() + 1);
        if (label.rfind("FLOW_", 0) != 0) labels[label] = count;
    }
    return labels;
}

void judge_labels(const io::InputCounts& read, const std::string& class_name, const std::string& key,
                  const std::string& wanted, const std::string& things, std::vector<Finding>& findings) {
    const auto labels = labels_of(read, class_name);
    if (labels.empty() || labels.count(wanted) > 0) return;
    std::string listed;
    std::uint64_t count = 0;
    for (const auto& [label, of_label] : labels) {
        listed += (listed.empty() ? "'" : ", '") + label + "' (" + std::to_string(of_label) + ')';
        count += of_label;
    }
    findings.push_back({key, std::to_string(count) + " poses of the " + things +
                                 " were ignored: they are labelled " + listed + ", and input." + key + " = " +
                                 wanted + "; set input." + key + " = " + labels.begin()->first +
                                 findings_page});
}

}  // namespace

std::vector<Finding> input_findings(const io::InputCounts& read, const config::InputConfig& input) {
    std::vector<Finding> findings;
    const std::array<Stream, io::event_kinds> streams = {
        {{io::EventKind::Image, "images", read.fields},
         {io::EventKind::Odometry, "odometry poses", read.odometry},
         {io::EventKind::GroundTruth, "ground truth poses", read.ground_truth},
         {io::EventKind::Gyro, "gyro readings", read.gyro}}};
    for (const Stream& stream : streams) {
        judge_counts(read, stream, findings);
        judge_clock(read, stream, findings);
    }
    judge_labels(read, "CObservationOdometry", "odometry_label", input.odometry_label, "odometry", findings);
    judge_labels(read, "CObservationRobotPose", "truth_label", input.truth_label, "ground truth", findings);
    return findings;
}

}  // namespace flownav::evaluation
