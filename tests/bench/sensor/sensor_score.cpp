#include "sensor_score.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "flownav/config/make_state.h"
#include "flownav/math/units.h"
#include "flownav/pipeline/pipeline.h"
#include "post_view.h"

namespace flownav::sensor_bench {
namespace {

using Eigen::Vector2d;
using pipeline::Step;

constexpr double near_m = 1.0;
constexpr double far_m = 3.0;
constexpr double in_view_share = 0.6;
constexpr double false_m = 0.2;
constexpr double gross_m = 0.4;
constexpr double own_m = 0.35;  ///< points within this distance of a post count for its range error
constexpr double margin_rad = 0.012;
constexpr double ahead_rad = 10.0 * degree_rad;
constexpr int pass_cycles_min = 3;
constexpr double steady_s = 0.25;

/// One pass of a post.
struct Pass {
    int cycles = 0;
    int detected_at = 0;  ///< cycle of the first detection; 0: not detected
    int gap = 0;
    bool ahead = false;
};

class Judge {
  public:
    Judge(const RecordedDrive& drive, Score& score)
        : drive_(drive), score_(score), passes_(drive.posts.size()) {}

    void field(const Step& step, std::size_t image) {
        ++score_.fields;
        score_.fields_ok += step.status == FieldStatus::Ok ? 1 : 0;
        if (image > 0 && step.status == FieldStatus::Ok && step.timestamp_s > 0.0) {
            const double dt = step.timestamp_s - drive_.fields[image - 1].timestamp_s;
            const double turn =
                wrap_angle(drive_.poses[image].yaw_rad - drive_.poses[image - 1].yaw_rad) / dt;
            score_.turn_error_degps.all.push_back(deg(step.omega_radps - turn));
        }
        if (!step.end_of_cycle) return;
        ++score_.cycles;
        if (step.v_measured) score_.speed_error.all.push_back(step.v_mps / drive_.options.speed_mps - 1.0);
        std::vector<bool> hit(drive_.posts.size(), false);
        int wrong = 0;
        for (const ObstaclePoint& point : step.obstacles) wrong += take_point(point, image, hit) ? 0 : 1;
        count_false(wrong);
        for (std::size_t post = 0; post < drive_.posts.size(); ++post) take_post(post, image, hit[post]);
    }

    void finish() {
        for (Pass& pass : passes_) end(pass);
    }

  private:
    /// Returns false for a point within four metres that is far from every post.
    bool take_point(const ObstaclePoint& point, std::size_t image, std::vector<bool>& hit) {
        const Vector2d in_robot = point.position_m.head<2>();
        const Vector2d at_m = transform(drive_.poses[image], in_robot);
        double nearest_m = 1e9;
        std::optional<double> error;
        for (std::size_t post = 0; post < drive_.posts.size(); ++post) {
            const double distance_m = surface_distance_m(drive_.posts[post], at_m);
            nearest_m = std::min(nearest_m, distance_m);
            if (distance_m <= false_m) hit[post] = true;
            if (distance_m > own_m) continue;
            const double range_m = range_along_m(drive_, post, image, in_robot, margin_rad);
            if (range_m <= 0.0) continue;
            const double e = in_robot.norm() / range_m - 1.0;
            if (!error || std::abs(e) < std::abs(*error)) error = e;
        }
        if (error) count_error(in_robot.norm() / (1.0 + *error), *error, image);
        const bool counts = in_robot.norm() <= range_limits_m.back();
        score_.points += counts ? 1 : 0;
        score_.gross_points += counts && nearest_m > gross_m ? 1 : 0;
        return !counts || nearest_m <= false_m;
    }

    void count_error(double range_m, double error, std::size_t image) {
        const auto bin = std::find_if(range_limits_m.begin(), range_limits_m.end(),
                                      [&](double limit) { return range_m <= limit; });
        if (bin == range_limits_m.end()) return;
        score_.range[static_cast<std::size_t>(bin - range_limits_m.begin())].all.push_back(error);
        if (range_m <= far_m && steady(image)) score_.range_steady.all.push_back(error);
    }

    bool steady(std::size_t image) const {
        const double now_s = drive_.fields[image].timestamp_s;
        for (std::size_t i = image + 1; i-- > 0 && now_s - drive_.fields[i].timestamp_s < steady_s;)
            if (std::abs(drive_.turn_radps[i] - drive_.turn_radps[image]) > 1e-6) return false;
        return true;
    }

    void count_false(int wrong) {
        score_.false_points += wrong;
        score_.false_cycles += wrong > 0 ? 1 : 0;
        score_.most_false = std::max(score_.most_false, wrong);
        burst_ = wrong > 0 ? burst_ + 1 : 0;
        score_.longest_burst = std::max(score_.longest_burst, burst_);
    }

    void take_post(std::size_t index, std::size_t image, bool hit) {
        Pass& pass = passes_[index];
        const Vector2d in_robot = transform(inverse(drive_.poses[image]), drive_.posts[index].at_m);
        const double range_m = in_robot.norm();
        const bool seen = in_robot.x() > 0.0 && range_m > near_m && range_m < far_m &&
                          visible_share(drive_, index, image) > in_view_share;
        if (!seen) {
            if (pass.cycles > 0 && ++pass.gap > 4) end(pass);
            return;
        }
        pass.gap = 0;
        if (pass.cycles++ == 0) pass.ahead = std::abs(std::atan2(in_robot.y(), in_robot.x())) < ahead_rad;
        ++score_.seen;
        score_.seen_hit += hit ? 1 : 0;
        if (hit && pass.detected_at == 0) pass.detected_at = pass.cycles;
    }

    void end(Pass& pass) {
        if (pass.cycles >= pass_cycles_min) {
            ++score_.passes;
            score_.ahead += pass.ahead ? 1 : 0;
            if (pass.detected_at == 0) {
                ++score_.missed;
                score_.ahead_missed += pass.ahead ? 1 : 0;
            } else {
                score_.cycles_to_detect.all.push_back(pass.detected_at);
            }
        }
        pass = {};
    }

    const RecordedDrive& drive_;
    Score& score_;
    std::vector<Pass> passes_;
    int burst_ = 0;
};

void append(Errors& to, const Errors& from) {
    to.all.insert(to.all.end(), from.all.begin(), from.all.end());
}

}  // namespace

double Errors::mean() const {
    double sum = 0.0;
    for (const double e : all) sum += e;
    return all.empty() ? NAN : sum / static_cast<double>(all.size());
}

double Errors::deviation() const {
    const double middle = mean();
    double sum = 0.0;
    for (const double e : all) sum += (e - middle) * (e - middle);
    return all.empty() ? NAN : std::sqrt(sum / static_cast<double>(all.size()));
}

double Errors::median() const {
    if (all.empty()) return NAN;
    std::vector<double> sorted = all;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

void Score::add(const Score& other) {
    for (std::size_t i = 0; i < range.size(); ++i) append(range[i], other.range[i]);
    append(range_steady, other.range_steady);
    append(cycles_to_detect, other.cycles_to_detect);
    append(turn_error_degps, other.turn_error_degps);
    append(speed_error, other.speed_error);
    passes += other.passes;
    missed += other.missed;
    ahead += other.ahead;
    ahead_missed += other.ahead_missed;
    seen += other.seen;
    seen_hit += other.seen_hit;
    cycles += other.cycles;
    points += other.points;
    false_points += other.false_points;
    gross_points += other.gross_points;
    false_cycles += other.false_cycles;
    longest_burst = std::max(longest_burst, other.longest_burst);
    most_false = std::max(most_false, other.most_false);
    fields += other.fields;
    fields_ok += other.fields_ok;
    seconds += other.seconds;
}

Score evaluate(const RecordedDrive& drive, const config::Config& config) {
    Score score;
    score.seconds = drive.options.seconds;
    Judge judge(drive, score);
    pipeline::State state = config::make_state(config);
    for (std::size_t i = 0; i < drive.fields.size(); ++i)
        judge.field(pipeline::step(state, drive.fields[i]), i);
    judge.finish();
    return score;
}

}  // namespace flownav::sensor_bench
