#include <algorithm>
#include <cmath>

#include "finding_text.h"
#include "flownav/evaluation/drive.h"
#include "flownav/evaluation/findings.h"
#include "flownav/math/units.h"

namespace flownav::evaluation {
namespace {

constexpr std::size_t fields_min = 3;        // fewer tell nothing about the drive
constexpr double shortest_period_s = 0.001;  // no camera of a robot is faster
constexpr double lost_told_share = 0.5;
constexpr double blind_told_share = 0.5;
constexpr double pitch_told_rad = 4.0 * degree_rad;  // is told when nearly all steps have its sign
constexpr double steady_share = 0.8;
constexpr double gap_key_max_s = 60.0;

double median_period_s(const std::vector<FieldRow>& rows) {
    std::vector<double> periods_s;
    for (std::size_t i = 1; i < rows.size(); ++i)
        periods_s.push_back(rows[i].timestamp_s - rows[i - 1].timestamp_s);
    if (periods_s.empty()) return 0.0;
    const auto middle = periods_s.begin() + static_cast<std::ptrdiff_t>(periods_s.size() / 2);
    std::nth_element(periods_s.begin(), middle, periods_s.end());
    return *middle;
}

std::uint64_t count_of(const std::vector<FieldRow>& rows, FieldStatus status) {
    const auto same = [status](const FieldRow& row) { return row.status == status; };
    return static_cast<std::uint64_t>(std::count_if(rows.begin(), rows.end(), same));
}

void judge_period(const std::vector<FieldRow>& rows, const pipeline::RateParams& rate,
                  std::vector<Finding>& findings) {
    const double period_s = median_period_s(rows);
    if (period_s > rate.gap_max_s) {
        std::string text = "the images are " + cli::fixed_text(period_s, 2) +
                           " s apart, more than motion.gap_max_s = " + cli::fixed_text(rate.gap_max_s, 2) +
                           ", so none was compared with the one before: ";
        text += period_s * 1.5 < gap_key_max_s
                    ? "set motion.gap_max_s = " + cli::fixed_text(period_s * 1.5, 1) +
                          " if the robot is slow, or record more images a second"
                    : "check the unit of the time stamps, which are seconds";
        findings.push_back({"images_too_rare", text + findings_page, true});
    } else if (rows.size() > fields_min && period_s < shortest_period_s) {
        findings.push_back({"images_too_frequent",
                            "the images are " + cli::fixed_text(1e6 * period_s, 1) +
                                " microseconds apart, so that no speed is right: check the unit of the time "
                                "stamps, which are seconds" +
                                std::string(findings_page),
                            true});
    }
}

void judge_bad_fields(std::uint64_t fields, const FieldFaultCounts& faults, std::vector<Finding>& findings) {
    std::uint64_t count = 0;
    std::string listed;
    for (const FieldFault fault : all_field_faults) {
        const std::uint64_t of_fault = faults.at(static_cast<std::size_t>(fault));
        if (fault == FieldFault::None || of_fault == 0) continue;
        count += of_fault;
        listed += (listed.empty() ? "" : ", ") + std::string(to_string(fault)) + " (" +
                  std::to_string(of_fault) + ')';
    }
    if (static_cast<double>(count) <= told_share * static_cast<double>(fields)) return;
    findings.push_back({"bad_fields",
                        counted(count, fields, "fields") + " could not be used: " + listed +
                            "; check exposure and driver of the camera" + findings_page,
                        true});
}

void judge_statuses(const std::vector<FieldRow>& rows, std::vector<Finding>& findings) {
    const std::uint64_t fields = rows.size();
    const auto share = [fields](std::uint64_t n) {
        return static_cast<double>(n) / static_cast<double>(fields);
    };
    const std::uint64_t lost = count_of(rows, FieldStatus::Lost);
    const std::uint64_t blind = count_of(rows, FieldStatus::NoTexture);
    if (share(lost) > lost_told_share) {
        findings.push_back(
            {"fields_lost",
             counted(lost, fields, "fields") +
                 " are lost, since their vectors agree on no motion: check the calibration and pose of the "
                 "camera, camera.rotate and camera.mirror, and camera.mask for the robot's own body" +
                 findings_page});
    }
    if (share(blind) > blind_told_share) {
        findings.push_back({"fields_without_texture",
                            counted(blind, fields, "fields") +
                                " show too little texture: check light, focus and exposure" + findings_page});
    }
}

/// A robot stays level: a view that goes on pitching is one that is upside down, or wrongly calibrated.
void judge_pitch(const std::vector<FieldRow>& rows, std::vector<Finding>& findings) {
    double pitch_rad = 0.0, steps_rad = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i].status != FieldStatus::Ok) continue;
        const double step_rad = rows[i].pitch_rate_radps * (rows[i].timestamp_s - rows[i - 1].timestamp_s);
        pitch_rad += step_rad;
        steps_rad += std::abs(step_rad);
    }
    if (std::abs(pitch_rad) < pitch_told_rad || std::abs(pitch_rad) < steady_share * steps_rad) return;
    findings.push_back(
        {"view_pitches",
         "the flow looks as if the robot had pitched by " + cli::fixed_text(deg(pitch_rad), 0) +
             " deg on the way, which no robot does: are the images upside down (camera.rotate = "
             "180), or the focal length or the pitch of the camera wrong?" +
             findings_page});
}

}  // namespace

std::vector<Finding> field_findings(const std::vector<FieldRow>& rows, const FieldFaultCounts& faults,
                                    const pipeline::RateParams& rate) {
    std::vector<Finding> findings;
    if (rows.empty()) return findings;
    judge_period(rows, rate, findings);
    judge_bad_fields(rows.size(), faults, findings);
    judge_statuses(rows, findings);
    judge_pitch(rows, findings);
    const std::uint64_t ok = count_of(rows, FieldStatus::Ok);
    if (findings.empty() && rows.size() >= fields_min && 2 * ok < rows.size()) {
        findings.push_back(
            {"few_fields_ok", "only " + counted(ok, rows.size(), "fields") +
                                  " measured a motion: see the status of each in egomotion.csv" +
                                  findings_page});
    }
    return findings;
}

}  // namespace flownav::evaluation
