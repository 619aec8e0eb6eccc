#include <algorithm>
#include <cmath>

#include "finding_text.h"
#include "flownav/evaluation/findings.h"
#include "flownav/math/units.h"

namespace flownav::evaluation {
namespace {

constexpr double chunk_min_s = 0.2;  // of the drive, for which both motions are compared
constexpr double chunk_max_s = 2.0;  // a longer one holds a pause
constexpr double path_min_m = 0.2;   // of the other track; a shorter one tells nothing
constexpr double path_share = 0.04;  // larger differences of the two lengths are told
constexpr double path_floor_m = 0.03;
constexpr double turn_min_rad = 15.0 * degree_rad;
constexpr double turn_share = 0.06;
constexpr double drift_min_rad = 3.0 * degree_rad;
constexpr double drift_share = 0.03;  // of all turns
constexpr double jump_min_mps = 2.0;  // between two poses of the track; far beyond its other speeds
constexpr double jump_min_radps = 6.0;
constexpr double jump_factor = 4.0;
constexpr double span_start_s = 1.0;
constexpr double span_share = 0.08;
constexpr double sideways_share = 0.2;
constexpr double covered_share = 0.5;
constexpr double offset_step_s = 0.02;
constexpr double offset_reach_s = 3.0;
constexpr double offset_min_s = 0.1;
constexpr double distinct = 0.3;      // of the disagreement at other offsets
constexpr double turn_lever_m = 0.5;  // weighs turns against ways

/// The motion during a part of the drive.
struct Chunk {
    double from_s = 0.0, to_s = 0.0;
    Pose2 flow;
    bool turn_by_flow = true;  ///< no other sensor told it
};

/// Motion of the track during a chunk, with its times shifted by `offset_s`; empty outside its span.
std::optional<Pose2> motion_of(const PoseTrack& track, const Chunk& chunk, double offset_s = 0.0) {
    const auto from = track.ground_at(chunk.from_s + offset_s);
    const auto to = track.ground_at(chunk.to_s + offset_s);
    if (!from || !to) return std::nullopt;
    return compose(inverse(*from), *to);
}

double length_m(const Pose2& moved) {
    return std::hypot(moved.x_m, moved.y_m);
}

/// Components of a motion along its mean heading, and to the left of that.
double along_m(const Pose2& moved) {
    return std::cos(moved.yaw_rad / 2) * moved.x_m + std::sin(moved.yaw_rad / 2) * moved.y_m;
}
double across_m(const Pose2& moved) {
    return std::cos(moved.yaw_rad / 2) * moved.y_m - std::sin(moved.yaw_rad / 2) * moved.x_m;
}

std::vector<Chunk> chunks_of(const std::vector<FieldRow>& rows) {
    std::vector<Chunk> chunks;
    std::size_t from = 0;
    bool by_flow = true;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        by_flow = by_flow && rows[i].omega_source == MotionSource::Flow;
        const double duration_s = rows[i].timestamp_s - rows[from].timestamp_s;
        if (duration_s < chunk_min_s) continue;
        if (duration_s <= chunk_max_s)
            chunks.push_back({rows[from].timestamp_s, rows[i].timestamp_s,
                              compose(inverse(rows[from].T_start_robot), rows[i].T_start_robot), by_flow});
        from = i;
        by_flow = true;
    }
    return chunks;
}

/// Mean squared difference of the two motions at an offset of the track's times; empty when less than half
/// of the chunks are in its span.
std::optional<double> disagreement(const std::vector<Chunk>& chunks, const PoseTrack& track,
                                   double offset_s) {
    double sum = 0.0;
    std::size_t compared = 0;
    for (const Chunk& chunk : chunks) {
        const auto other = motion_of(track, chunk, offset_s);
        if (!other) continue;
        ++compared;
        const double way_m = along_m(chunk.flow) - along_m(*other);
        const double turn_m = turn_lever_m * (chunk.flow.yaw_rad - other->yaw_rad);
        sum += way_m * way_m + turn_m * turn_m;
    }
    if (2 * compared < chunks.size() || compared == 0) return std::nullopt;
    return sum / static_cast<double>(compared);
}

/// Offset of the track's times at which both motions agree best.
struct Offset {
    double offset_s = 0.0;
    double disagreement = 0.0;
    double typical = 0.0;  ///< disagreement at other offsets
};

std::optional<Offset> best_offset(const std::vector<Chunk>& chunks, const PoseTrack& track, double about_s) {
    std::optional<Offset> best;
    std::vector<double> all;
    const int steps = static_cast<int>(offset_reach_s / offset_step_s);
    for (int i = -steps; i <= steps; ++i) {
        const double offset_s = about_s + i * offset_step_s;
        const auto value = disagreement(chunks, track, offset_s);
        if (!value) continue;
        all.push_back(*value);
        if (!best || *value < best->disagreement) best = Offset{offset_s, *value, 0.0};
    }
    if (!best) return std::nullopt;
    std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
    best->typical = all[all.size() / 2];
    return best;
}

/// A step from one pose of a track to the next that no robot makes.
struct Jump {
    double at_s = 0.0;
    double way_m = 0.0;
};

std::vector<Jump> jumps_of(const PoseTrack& track) {
    struct Step {
        double at_s, way_m, v_mps, omega_radps;
    };
    std::vector<Step> steps;
    std::vector<double> speeds_mps, rates_radps;
    const auto& samples = track.samples();
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const auto& a = samples[i - 1].pose;
        const auto& b = samples[i].pose;
        const double dt_s = samples[i].timestamp_s - samples[i - 1].timestamp_s;
        const double way_m = std::hypot(b.x - a.x, b.y - a.y);
        steps.push_back(
            {samples[i].timestamp_s, way_m, way_m / dt_s, std::abs(wrap_angle(b.yaw - a.yaw)) / dt_s});
        speeds_mps.push_back(steps.back().v_mps);
        rates_radps.push_back(steps.back().omega_radps);
    }
    const auto usual = [](std::vector<double>& values) {
        const auto at = values.begin() + static_cast<std::ptrdiff_t>(9 * (values.size() - 1) / 10);
        std::nth_element(values.begin(), at, values.end());
        return *at;
    };
    const double v_max_mps = std::max(jump_min_mps, jump_factor * usual(speeds_mps));
    const double omega_max_radps = std::max(jump_min_radps, jump_factor * usual(rates_radps));
    std::vector<Jump> jumps;
    for (const Step& step : steps)
        if (step.v_mps > v_max_mps || step.omega_radps > omega_max_radps)
            jumps.push_back({step.at_s, step.way_m});
    return jumps;
}

class TrackJudge {
  public:
    TrackJudge(const std::vector<FieldRow>& rows, const PoseTrack& track, const std::string& name)
        : rows_(rows), track_(track), name_(name), chunks_(chunks_of(rows)) {}

    std::vector<Finding> findings() {
        if (!covers_the_images()) return std::move(findings_);
        judge_jumps();
        judge_offset();
        judge_way();
        judge_turn();
        if (!findings_.empty()) judge_span();
        return std::move(findings_);
    }

  private:
    void tell(const std::string& reason, const std::string& sentence, bool loses_data = false) {
        findings_.push_back({reason, sentence + findings_page, loses_data});
    }

    std::string offset_advice(double offset_s) const {
        return name_ == "odometry" ? "set input.odometry_offset_s = " + cli::fixed_text(-offset_s, 2) +
                                         ", or record both with one clock"
                                   : "record both with one clock";
    }

    bool covers_the_images() {
        std::size_t covered = 0;
        for (const FieldRow& row : rows_) covered += track_.ground_at(row.timestamp_s).has_value();
        if (static_cast<double>(covered) >= covered_share * static_cast<double>(rows_.size())) return true;
        const double starts_s = track_.samples().front().timestamp_s - rows_.front().timestamp_s;
        const auto best = best_offset(chunks_, track_, starts_s);
        const bool sure = best && best->disagreement < distinct * best->typical;
        const double offset_s = sure ? best->offset_s : starts_s;
        tell(name_key() + "_times",
             "the times of the " + name_ + " fit only " + counted(covered, rows_.size(), "images") +
                 ", and it was not used for the others: it is about " +
                 cli::fixed_text(std::abs(offset_s), 2) + (offset_s > 0 ? " s later" : " s earlier") +
                 (sure ? ", by the motion of both; " : ", by its start; ") + offset_advice(offset_s));
        return false;
    }

    /// Tells jumps of the track, and leaves them out of all comparisons.
    void judge_jumps() {
        const std::vector<Jump> jumps = jumps_of(track_);
        if (jumps.empty()) return;
        const auto holds_jump = [&jumps](const Chunk& chunk) {
            return std::any_of(jumps.begin(), jumps.end(), [&chunk](const Jump& jump) {
                return jump.at_s > chunk.from_s && jump.at_s < chunk.to_s + chunk_min_s;
            });
        };
        chunks_.erase(std::remove_if(chunks_.begin(), chunks_.end(), holds_jump), chunks_.end());
        tell(name_key() + "_jumps", "the " + name_ + " jumps " + std::to_string(jumps.size()) +
                                        (jumps.size() == 1 ? " time" : " times") + ", first by " +
                                        cli::fixed_text(jumps.front().way_m, 2) + " m at " +
                                        cli::fixed_text(jumps.front().at_s - rows_.front().timestamp_s, 2) +
                                        " s: was it reset? The errors against it are wrong from there on");
    }

    /// Two clocks that run at different speeds make all other comparisons wrong.
    void judge_span() {
        const auto& poses = track_.samples();
        const double images_s = rows_.back().timestamp_s - rows_.front().timestamp_s;
        const double track_s = poses.back().timestamp_s - poses.front().timestamp_s;
        const bool same_start =
            std::abs(poses.front().timestamp_s - rows_.front().timestamp_s) < span_start_s;
        if (!same_start || std::abs(track_s / images_s - 1.0) < span_share) return;
        tell(name_key() + "_span", "the images last " + cli::fixed_text(images_s, 2) + " s, the " + name_ +
                                       ' ' + cli::fixed_text(track_s, 2) +
                                       " s, although both begin together, and their motions differ: does the "
                                       "clock of one of them run wrong?");
    }

    void judge_offset() {
        const auto best = best_offset(chunks_, track_, 0.0);
        const auto now = disagreement(chunks_, track_, 0.0);
        if (!best || !now || std::abs(best->offset_s) < offset_min_s) return;
        const double floor = path_floor_m * path_floor_m / 16;
        if (best->disagreement + floor > distinct * *now) return;
        tell(name_key() + "_offset", "the " + name_ + " moves " +
                                         cli::fixed_text(std::abs(best->offset_s), 2) +
                                         (best->offset_s > 0 ? " s later" : " s earlier") +
                                         " than the images: " + offset_advice(best->offset_s));
    }

    void judge_way() {
        double flow_m = 0.0, other_m = 0.0, products = 0.0, squares = 0.0, aside_m = 0.0;
        for (const Chunk& chunk : chunks_) {
            const auto other = motion_of(track_, chunk);
            if (!other) continue;
            flow_m += length_m(chunk.flow);
            other_m += length_m(*other);
            aside_m += std::abs(across_m(*other));
            products += along_m(chunk.flow) * along_m(*other);
            squares += along_m(*other) * along_m(*other);
        }
        const std::string lengths = cli::fixed_text(flow_m, 2) + " m by the flow, " +
                                    cli::fixed_text(other_m, 2) + " m by the " + name_;
        if (other_m > path_min_m && aside_m > sideways_share * other_m) {
            tell(name_key() + "_sideways",
                 "the robot moves sideways for " + cli::fixed_text(aside_m, 2) + " of " +
                     cli::fixed_text(other_m, 2) + " m by the " + name_ +
                     ", which the flow cannot tell: flownav is for robots that drive "
                     "along their heading; check also the axes of the " +
                     name_);
            return;
        }
        if (std::max(flow_m, other_m) < path_min_m) return;
        if (products < -0.5 * squares) {
            tell(name_key() + "_way_reversed",
                 "the flow drives backwards where the " + name_ +
                     " drives ahead: are the images upside down (camera.rotate = "
                     "180), or is the sign of the " +
                     name_ + " wrong?");
        } else if (std::abs(flow_m - other_m) > std::max(path_floor_m, path_share * other_m)) {
            tell(name_key() + "_way", "the length of the way differs: " + lengths +
                                          "; check camera.height_m, camera.pitch_deg, the calibration, the "
                                          "scale and times of the " +
                                          name_ + ", and camera.mask for the robot's own body");
        }
    }

    void judge_drift(double drift_rad) {
        tell(name_key() + "_heading",
             "the heading of the flow ends " + cli::fixed_text(std::abs(deg(drift_rad)), 1) +
                 (drift_rad > 0 ? " deg to the left" : " deg to the right") + " of that of the " + name_ +
                 ": check camera.yaw_deg, camera.roll_deg, the calibration, and the "
                 "scale of the turns of the " +
                 name_);
    }

    void judge_turn() {
        double products = 0.0, squares = 0.0, amount_rad = 0.0, drift_rad = 0.0;
        for (const Chunk& chunk : chunks_) {
            const auto other = motion_of(track_, chunk);
            if (!other || !chunk.turn_by_flow) continue;
            products += chunk.flow.yaw_rad * other->yaw_rad;
            squares += other->yaw_rad * other->yaw_rad;
            amount_rad += std::abs(other->yaw_rad);
            drift_rad += chunk.flow.yaw_rad - other->yaw_rad;
        }
        const bool drifts = std::abs(drift_rad) > std::max(drift_min_rad, drift_share * amount_rad);
        if (drifts) judge_drift(drift_rad);
        if (amount_rad < turn_min_rad || squares <= 0.0) return;
        const double ratio = products / squares;
        if (ratio < 0.0) {
            tell(name_key() + "_turn_reversed", "the flow turns to the other side than the " + name_ +
                                                    ": are the images mirrored (camera.mirror = true) or "
                                                    "upside down (camera.rotate = 180), or "
                                                    "is the sign of the " +
                                                    name_ + " wrong?");
        } else if (std::abs(ratio - 1.0) > turn_share) {
            tell(name_key() + "_turn", "the flow turns " + cli::fixed_text(ratio, 2) +
                                           " times as far as the " + name_ +
                                           ": check camera.fx_px and the calibration, and the scale "
                                           "and times of the " +
                                           name_);
        }
    }

    /// The name as a word of a reason.
    std::string name_key() const { return name_ == "odometry" ? "odometry" : "ground_truth"; }

    const std::vector<FieldRow>& rows_;
    const PoseTrack& track_;
    std::string name_;
    std::vector<Chunk> chunks_;
    std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> track_findings(const std::vector<FieldRow>& rows, const PoseTrack& track,
                                    const std::string& name) {
    if (rows.empty() || track.size() < 2) return {};
    return TrackJudge(rows, track, name).findings();
}

}  // namespace flownav::evaluation
