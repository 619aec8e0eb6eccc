#include "flownav/evaluation/camera_check.h"

#include <algorithm>
#include <cmath>

#include "flownav/cli/number_text.h"
#include "flownav/math/units.h"

namespace flownav::evaluation {
namespace {

constexpr int pairs_min = 16;
constexpr int settling_pairs = 4;
constexpr double sigma_max_deg = 1.0;
constexpr double agreeing_min = 0.65;  // share of the near vectors; below, the floor is not plane or not free
constexpr double matching_sigma_deg = 0.1;
constexpr double significant = 4.0;  // standard deviations
constexpr double ratio_sigma_max = 0.1;
constexpr double ratio_by_pitch_min = 0.4, ratio_by_pitch_max = 2.5;
constexpr double pitch_at_max_rad = 15 * degree_rad;
constexpr double unit_tolerance = 0.25;  // of log(ratio * 100), to detect a height in centimetres

// Errors of parts of a pixel do not average out in shorter flows, those of a robot that crawls.
constexpr double flow_min_px = 9.0;

constexpr const char* advice = "; flownav-calibrate estimates it from this drive";

void check_angle(CameraCheck& check, int i, const char* key, double assumed_rad) {
    const double error_deg = check.angles.correction_rad[i] / degree_rad;
    const double sigma_deg = check.angles.sigma_rad[i] / degree_rad;
    if (sigma_deg > sigma_max_deg || std::abs(error_deg) < CameraCheck::angle_limit_deg ||
        std::abs(error_deg) < significant * sigma_deg)
        return;
    check.verdict = "pose_contradicts_flow";
    check.warnings.push_back("camera." + std::string(key) + " = " +
                             cli::fixed_text(assumed_rad / degree_rad, 2) +
                             " contradicts the flow of the floor, which looks like " +
                             cli::fixed_text(assumed_rad / degree_rad + error_deg, 1) + " (uncertainty " +
                             cli::fixed_text(std::max(sigma_deg, matching_sigma_deg), 1) + ")" + advice);
}

void check_height(CameraCheck& check) {
    const double ratio = check.scale->ratio;
    if (check.scale->sigma > ratio_sigma_max * ratio ||
        (ratio > CameraCheck::ratio_low && ratio < CameraCheck::ratio_high))
        return;
    // A wrong pitch changes the ratio as well.
    if (!check.warnings.empty() && ratio > ratio_by_pitch_min && ratio < ratio_by_pitch_max) return;
    if (check.warnings.empty()) check.verdict = "height_contradicts_odometry";
    const bool centimetres = std::abs(std::log(ratio * 100)) < unit_tolerance;
    check.warnings.push_back(
        "camera.height_m = " + cli::fixed_text(check.height_m, 3) +
        " contradicts the odometry: its distances are " + cli::fixed_text(ratio, ratio < 0.1 ? 4 : 2) +
        " times those of the flow, so the height looks like " + cli::fixed_text(check.height_m * ratio, 3) +
        " m" + (centimetres ? "; was it given in centimetres?" : "") +
        " (flownav-calibrate --odometry estimates it)");
}

/// True when the flow of the floor near the robot is long enough for a check of the pose.
bool has_long_flow(const CameraModel& camera, const EgoMotion& motion) {
    const double travel_px = std::abs(motion.forward_m) / camera.mount.height_m * camera.fy_px;
    const double turn_px = std::abs(motion.omega_rad) * camera.fx_px;
    return std::max(travel_px, turn_px) >= flow_min_px;
}

}  // namespace

void CameraChecker::take(const Field& field, const pipeline::Step& step) {
    if (step.end_of_cycle && step.status == FieldStatus::Ok) {
        mount_ = field.camera.mount;
        compare(field, step);
        if (step.motion.forward_source == MotionSource::Flow)
            pieces_.push_back({reference_s_, step.timestamp_s, step.motion.forward_m});
    }
    if (step.end_of_cycle || step.image_of_cycle == 0) reference_s_ = step.timestamp_s;
}

/// Adds the equations of a cycle.
void CameraChecker::compare(const Field& field, const pipeline::Step& step) {
    rays_.clear();
    for (const pipeline::BlockRecord& block : step.blocks)
        if (block.fresh) rays_.push_back(block.ray);
    CameraModel camera = field.camera;
    camera.mount.pitch_rad += pitch_at_rad_;
    const motion::PairFit fit = motion::fit_pair(rays_, camera, step.motion, geometry_, {}, scratch_);
    near_vectors_ += fit.near_vectors;
    close_vectors_ += fit.close_vectors;
    if (!has_long_flow(field.camera, step.motion)) return;
    sum_.add(fit.equations, {pitch_at_rad_, 0.0, 0.0});
    if (sum_.pairs() < settling_pairs) return;
    const double found_rad = motion::solve(sum_.total()).correction_rad[0];
    pitch_at_rad_ = std::clamp(found_rad, -pitch_at_max_rad, pitch_at_max_rad);
}

CameraCheck CameraChecker::result(const PoseTrack& odometry) const {
    CameraCheck check;
    check.pairs = sum_.pairs();
    check.height_m = mount_.height_m;
    check.angles = sum_.solution();
    check.agreeing = near_vectors_ > 0 ? close_vectors_ / near_vectors_ : 0.0;
    check.angles_known = check.pairs >= pairs_min && check.agreeing >= agreeing_min &&
                         check.angles.sigma_rad[0] < sigma_max_deg * degree_rad;
    if (check.angles_known) {
        check.verdict = "consistent";
        check_angle(check, 0, "pitch_deg", mount_.pitch_rad);
        check_angle(check, 1, "roll_deg", mount_.roll_rad);
        check_angle(check, 2, "yaw_deg", mount_.yaw_rad);
    }
    check.scale = fit_scale(pieces_, odometry);
    if (check.scale) check_height(check);
    return check;
}

}  // namespace flownav::evaluation
