#include "flownav/evaluation/drive.h"

#include <algorithm>
#include <iterator>

#include "flownav/cli/number_text.h"
#include "flownav/evaluation/motion_sources.h"

namespace flownav::evaluation {
namespace {

/// A finding, and one that it causes as well.
struct Cause {
    const char* cause;
    const char* consequence;
};

constexpr Cause causes[] = {
    {"time_repeated", "images_too_rare"},
    // A camera that is upside down or wrongly calibrated makes every estimate of its pose wrong.
    {"principal_point_off_centre", "pose_contradicts_flow"},
    {"principal_point_off_centre", "height_contradicts_odometry"},
    {"view_pitches", "pose_contradicts_flow"},
    {"view_pitches", "height_contradicts_odometry"},
    {"odometry_way_reversed", "pose_contradicts_flow"},
    {"odometry_turn_reversed", "pose_contradicts_flow"},
    {"odometry_turn_reversed", "height_contradicts_odometry"},
    {"odometry_sideways", "height_contradicts_odometry"},
    {"height_contradicts_odometry", "odometry_way"},
    {"odometry_way", "wheels_way"},
    {"odometry_way_reversed", "wheels_way"},
    {"odometry_sideways", "wheels_way"},
    {"odometry_turn", "wheels_turn"},
    {"odometry_turn_reversed", "wheels_turn"},
    {"odometry_times", "wheels_times"},
    {"odometry_span", "odometry_way"},
    {"odometry_span", "odometry_offset"},
    {"odometry_span", "odometry_turn"},
    {"odometry_span", "odometry_turn_reversed"},
    {"odometry_span", "height_contradicts_odometry"},
    {"odometry_span", "wheels_way"},
    {"odometry_span", "wheels_turn"},
    {"odometry_span", "wheels_times"},
    {"odometry_turn", "odometry_heading"},
    {"odometry_turn_reversed", "odometry_heading"},
    {"odometry_span", "odometry_heading"},
    {"odometry_offset", "odometry_heading"},
    {"odometry_offset", "odometry_way"},
    {"odometry_offset", "odometry_turn"},
    {"odometry_offset", "odometry_turn_reversed"},
    {"odometry_offset", "wheels_times"},
    {"odometry_jumps", "wheels_way"},
    {"odometry_jumps", "wheels_turn"},
    {"odometry_offset", "wheels_way"},
    {"odometry_offset", "wheels_turn"},
};

/// The findings without those that another one of them causes.
std::vector<Finding> without_consequences(const std::vector<Finding>& findings) {
    const auto has = [&findings](const std::string& reason) {
        return std::any_of(findings.begin(), findings.end(),
                           [&reason](const Finding& finding) { return finding.reason == reason; });
    };
    std::vector<Finding> kept;
    for (const Finding& finding : findings) {
        const auto explains = [&](const Cause& cause) {
            return finding.reason == cause.consequence && has(cause.cause);
        };
        if (std::none_of(std::begin(causes), std::end(causes), explains)) kept.push_back(finding);
    }
    return kept;
}

}  // namespace

const char* end_word(const Drive& drive) {
    if (!drive.stop_reason.empty()) return "unusable_image";
    switch (drive.end.kind) {
        case io::ReadEnd::Kind::NotYet:
            return "not_at_end";
        case io::ReadEnd::Kind::Clean:
            return "clean";
        case io::ReadEnd::Kind::Truncated:
            return "truncated";
        case io::ReadEnd::Kind::Corrupt:
            return "corrupt";
        case io::ReadEnd::Kind::UnknownClass:
            return "unknown_class";
    }
    return "unknown";
}

std::string end_sentence(const Drive& drive) {
    const bool stopped = !drive.stop_reason.empty();
    const std::string objects = std::to_string(drive.end.objects_read) + " objects";
    if (drive.end.kind == io::ReadEnd::Kind::Clean && !stopped) {
        return "The input was read to its clean end (" + objects + ").";
    }
    const std::string problem = "The input could not be read to its end: ";
    if (!stopped) return problem + drive.end.message;
    return problem + drive.stop_reason + ". What came before was used.";
}

std::vector<std::uint64_t> status_counts(const std::vector<FieldRow>& rows) {
    std::vector<std::uint64_t> counts;
    for (const FieldStatus status : all_field_statuses) {
        const auto same = [status](const FieldRow& row) { return row.status == status; };
        counts.push_back(static_cast<std::uint64_t>(std::count_if(rows.begin(), rows.end(), same)));
    }
    return counts;
}

CarriedTime carried_time(const std::vector<FieldRow>& rows) {
    CarriedTime carried;
    if (rows.empty()) return carried;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double before_s = rows[i - 1].carried.since_s;
        carried.total_s += std::max(0.0, rows[i].carried.since_s - before_s);
        carried.longest_s = std::max(carried.longest_s, rows[i].carried.since_s);
    }
    carried.duration_s = rows.back().timestamp_s - rows.front().timestamp_s;
    carried.sigma_m = rows.back().carried.sigma_m;
    return carried;
}

std::string carried_warning(const CarriedTime& carried, double carry_max_s) {
    constexpr double share_max = 0.02;
    constexpr double reported_min_s = 0.5;
    const double unreported_max_s = std::max(reported_min_s, share_max * carried.duration_s);
    if (carried.total_s <= unreported_max_s && carried.longest_s <= carry_max_s) return "";
    return "the motion could not be measured during " + cli::fixed_text(carried.total_s, 1) + " s of " +
           cli::fixed_text(carried.duration_s, 1) + " s, for " + cli::fixed_text(carried.longest_s, 1) +
           " s at a stretch: the pose was carried over for up to " + cli::fixed_text(carry_max_s, 1) +
           " s (motion.carry_max_s), its end may be off by " + cli::fixed_text(carried.sigma_m, 2) +
           " m; see carried_s in egomotion.csv";
}

std::string map_warning(int sets, int sets_outside, double half_m) {
    if (sets_outside == 0) return "";
    return "the map lacks " + std::to_string(sets_outside) + " of " + std::to_string(sets) +
           " cycles, which were seen more than " + cli::fixed_text(half_m, 0) +
           " m from the start: a larger map.resolution_m reaches farther, at most 1000 m";
}

std::vector<Finding> judge(const Drive& drive, const config::Config& config, const std::string& map_warning) {
    std::vector<Finding> findings = input_findings(drive.read, config.input);
    const auto add = [&findings](const std::vector<Finding>& more) {
        findings.insert(findings.end(), more.begin(), more.end());
    };
    const auto add_sentence = [&findings](const char* reason, const std::string& sentence) {
        if (!sentence.empty()) findings.push_back({reason, sentence});
    };
    add(field_findings(drive.rows, drive.field_faults, config.pipeline.rate));
    const bool wheels = !drive.odometry.empty();
    add(track_findings(drive.rows, wheels ? drive.odometry : drive.ground_truth,
                       wheels ? "odometry" : "ground truth"));
    for (const std::string& sentence : drive.camera_check.warnings)
        add_sentence(drive.camera_check.verdict, sentence);
    add(sensor_findings(drive.rows));
    add_sentence("pose_carried", carried_warning(carried_time(drive.rows), config.pipeline.rate.carry_max_s));
    add_sentence("map_too_small", map_warning);
    return without_consequences(findings);
}

const char* explain(FieldStatus status) {
    switch (status) {
        case FieldStatus::Ok:
            return "The flow measured the turn rate with this field.";
        case FieldStatus::Waiting:
            return "The first field, or the first after a gap: there is nothing to compare it with yet.";
        case FieldStatus::Lost:
            return "There were vectors, but no common motion explains them: very fast turns, a mover that "
                   "fills "
                   "the view, or a wrong camera pose.";
        case FieldStatus::NoTexture:
            return "Too few unambiguous vectors: a smooth floor, darkness or motion blur.";
        case FieldStatus::BadField:
            return "It cannot be used: no picture (black, saturated or constant), an image that is not as "
                   "large "
                   "as its camera says, or a time stamp that does not rise.";
    }
    return "";
}

}  // namespace flownav::evaluation
