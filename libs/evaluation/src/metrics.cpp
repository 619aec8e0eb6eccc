#include "flownav/evaluation/metrics.h"

#include <cmath>

#include "flownav/math/units.h"

namespace flownav::evaluation {

namespace {

constexpr double slowest_compared_mps = 0.05;
constexpr double shortest_path_m = 0.01;

Pose2 between(const Pose2& a, const Pose2& b) {
    return compose(inverse(a), b);
}

/// Distance from a to b, negative when b lies behind a.
double signed_chord(const Pose2& a, const Pose2& b) {
    const Pose2 step = between(a, b);
    return std::copysign(std::hypot(step.x_m, step.y_m), step.x_m);
}

struct Moments {
    std::uint64_t count = 0;
    double sum = 0.0;
    double sum_of_squares = 0.0;

    void add(double value) {
        ++count;
        sum += value;
        sum_of_squares += value * value;
    }
    double mean() const { return sum / static_cast<double>(count); }
    double rms() const { return std::sqrt(sum_of_squares / static_cast<double>(count)); }
    double deviation() const { return std::sqrt(std::max(0.0, rms() * rms() - mean() * mean())); }
};

/// Compares flow odometry with another track field by field. `truth`: the track's pose at the field's time;
/// empty outside its span.
class Comparison {
  public:
    void add(const FieldRow& row, const std::optional<Pose2>& truth) {
        if (truth) compare_pose(row, *truth);
        if (truth && index_ > Errors::settling_fields && row.status == FieldStatus::Ok) {
            compare_omega(row, *truth);
            compare_speed(row, *truth);
        }
        if (row.end_of_cycle || row.status != FieldStatus::Ok) finish_cycle();
        remember(row, truth);
    }

    Errors result() const {
        Errors errors;
        errors.fields_compared = fields_compared_;
        if (fields_compared_ > 0) errors.path_m = path_m_;
        if (omega_degps_.count > 0) errors.omega_rms_degps = omega_degps_.rms();
        if (omega_cycle_degps_.count > 0) errors.omega_cycle_rms_degps = omega_cycle_degps_.rms();
        if (v_percent_.count > 0) errors.v_bias_percent = v_percent_.mean();
        if (v_percent_.count > 0) errors.v_sd_percent = v_percent_.deviation();
        if (cycles_ > 0) {
            errors.t_measured_percent =
                100.0 * static_cast<double>(cycles_measured_) / static_cast<double>(cycles_);
        }
        if (fields_compared_ > 1) compare_ends(errors);
        return errors;
    }

  private:
    struct Both {
        Pose2 flow;
        Pose2 truth;
    };

    void compare_pose(const FieldRow& row, const Pose2& truth) {
        const Both both = {row.T_start_robot, truth};
        if (fields_compared_ == 0) first_ = both;
        if (fields_compared_ > 0)
            path_m_ += std::hypot(truth.x_m - last_.truth.x_m, truth.y_m - last_.truth.y_m);
        last_ = both;
        ++fields_compared_;
    }

    void compare_omega(const FieldRow& row, const Pose2& truth) {
        if (!previous_truth_) return;
        const double dt_s = row.timestamp_s - previous_s_;
        const double truth_radps = wrap_angle(truth.yaw_rad - previous_truth_->yaw_rad) / dt_s;
        const double error_degps = deg(row.omega_radps - truth_radps);
        omega_degps_.add(error_degps);
        cycle_degps_.add(error_degps);
    }

    void compare_speed(const FieldRow& row, const Pose2& truth) {
        if (row.end_of_cycle) ++cycles_;
        if (!row.v_measured) return;
        ++cycles_measured_;
        if (!reference_truth_) return;
        const double truth_mps = signed_chord(*reference_truth_, truth) / (row.timestamp_s - reference_s_);
        if (truth_mps > slowest_compared_mps) v_percent_.add(100.0 * (row.v_mps / truth_mps - 1.0));
    }

    void finish_cycle() {
        if (cycle_degps_.count > 0) omega_cycle_degps_.add(cycle_degps_.mean());
        cycle_degps_ = {};
    }

    void remember(const FieldRow& row, const std::optional<Pose2>& truth) {
        ++index_;
        previous_s_ = row.timestamp_s;
        previous_truth_ = truth;
        if (!row.starts_reference) return;
        reference_s_ = row.timestamp_s;
        reference_truth_ = truth;
    }

    void compare_ends(Errors& errors) const {
        const Pose2 flow = between(first_.flow, last_.flow);
        const Pose2 truth = between(first_.truth, last_.truth);
        errors.heading_end_deg = deg(wrap_angle(flow.yaw_rad - truth.yaw_rad));
        if (path_m_ < shortest_path_m) return;
        errors.end_position_percent =
            100.0 * std::hypot(flow.x_m - truth.x_m, flow.y_m - truth.y_m) / path_m_;
    }

    std::size_t index_ = 0;
    std::uint64_t fields_compared_ = 0;
    std::uint64_t cycles_ = 0;
    std::uint64_t cycles_measured_ = 0;
    double path_m_ = 0.0;
    double previous_s_ = 0.0;
    double reference_s_ = 0.0;
    std::optional<Pose2> previous_truth_;
    std::optional<Pose2> reference_truth_;
    Both first_;
    Both last_;
    Moments omega_degps_;
    Moments cycle_degps_;
    Moments omega_cycle_degps_;
    Moments v_percent_;
};

}  // namespace

LabelCounts label_counts_of(const pipeline::Step& step) {
    LabelCounts counts{};
    for (const pipeline::BlockRecord& block : step.blocks) ++counts.at(static_cast<std::size_t>(block.label));
    return counts;
}

ContactRow contact_row_of(const pipeline::Step& step) {
    if (!step.new_contacts) return {};
    const ContactScan& scan = step.contacts;
    return {true, scan.gate, counts_of(scan), scan.floor.fit_share, scan.floor.vignetting};
}

FieldRow row_of(const pipeline::Step& step) {
    FieldRow row;
    row.timestamp_s = step.timestamp_s;
    row.status = step.status;
    row.v_measured = step.v_measured;
    row.starts_reference = step.end_of_cycle || step.image_of_cycle == 0;
    row.omega_radps = step.omega_radps;
    row.v_mps = step.v_mps;
    row.pitch_rate_radps = step.pitch_rate_radps;
    row.omega_source = step.motion.omega_source;
    row.forward_source = step.motion.forward_source;
    row.other_sensors = step.other_sensors;
    row.carried = step.carried;
    row.T_start_robot = step.T_start_robot;
    row.placed = step.counts.placed;
    row.confident = step.counts.confident;
    row.inliers = step.counts.inliers;
    row.ground_window = step.counts.ground_window;
    row.obstacles = static_cast<int>(step.obstacles.size());
    row.end_of_cycle = step.end_of_cycle;
    row.labels = label_counts_of(step);
    row.contacts = contact_row_of(step);
    return row;
}

Errors compare(const std::vector<FieldRow>& rows, const PoseTrack& track) {
    Comparison comparison;
    for (const FieldRow& row : rows) comparison.add(row, track.ground_at(row.timestamp_s));
    return comparison.result();
}

const std::array<Figure, 8>& error_figures() {
    static const std::array<Figure, 8> figures = {{
        {"omega_rms_degps", "deg/s", "turn rate, root mean square error per field", &Errors::omega_rms_degps},
        {"omega_cycle_rms_degps", "deg/s", "turn rate, root mean square of the mean error over a cycle",
         &Errors::omega_cycle_rms_degps},
        {"v_bias_percent", "%", "forward speed, mean error of the cycles that measured it",
         &Errors::v_bias_percent},
        {"v_sd_percent", "%", "forward speed, standard deviation of that error", &Errors::v_sd_percent},
        {"t_measured_percent", "%", "share of the finished cycles whose forward speed was measured",
         &Errors::t_measured_percent},
        {"end_position_percent", "%", "distance between the end positions, of the path's length",
         &Errors::end_position_percent},
        {"heading_end_deg", "deg", "difference of the end headings, > 0: flow odometry too far left",
         &Errors::heading_end_deg},
        {"path_m", "m", "length of the path compared with", &Errors::path_m},
    }};
    return figures;
}

}  // namespace flownav::evaluation
