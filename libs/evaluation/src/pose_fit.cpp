#include "flownav/evaluation/pose_fit.h"

#include <algorithm>
#include <cmath>

#include "flownav/math/units.h"
#include "flownav/motion/ray_flow.h"
#include "flownav/motion/robust.h"

namespace flownav::evaluation {
namespace {

constexpr int rounds_max = 25;
constexpr double settled_rad = 1e-5;
constexpr double step_max_rad = 4 * degree_rad;  // largest step, in which the equations are about linear
constexpr double sigma_min_rad = 0.002 * degree_rad;
constexpr int groups_wanted = 20;
constexpr int scale_pairs_min = 8;
constexpr double travel_min_m = 0.01;

}  // namespace

void PoseSum::add(motion::PoseEquations pair, const motion::MountAngles& at_rad) {
    if (pair.pairs == 0) return;
    pair.gradient += pair.information * at_rad;
    if (pairs_++ % pairs_per_group_ == 0) groups_.emplace_back();
    groups_.back() += pair;
    total_ += pair;
}

motion::PoseCorrection PoseSum::solution(const motion::AngleMask& unknown) const {
    motion::PoseEquations all = motion::select(total_, unknown);
    const motion::MountAngles correction = motion::solve(all).correction_rad;
    all.scatter.setZero();
    all.gradient.setZero();
    for (const motion::PoseEquations& group : groups_) {
        const motion::PoseEquations part = motion::select(group, unknown);
        const motion::MountAngles rest = part.gradient - part.information * correction;
        all.scatter += rest * rest.transpose();
    }
    return {correction, motion::solve(all).sigma_rad};
}

SeenPair seen(const CalibrationPair& pair, const motion::MountAngles& correction_rad) {
    CameraModel reference = pair.reference;
    CameraModel newer = pair.newer;
    reference.mount = motion::corrected(reference.mount, correction_rad);
    newer.mount = motion::corrected(newer.mount, correction_rad);
    SeenPair s{reference, RayMapper(reference), RayMapper(newer), {}};
    s.rays.reserve(pair.vectors.size());
    for (const FlowVector& v : pair.vectors)
        s.rays.push_back(motion::ray_flow(v, s.reference, s.newer, Geometry::MidPoint));
    return s;
}

namespace {

/// Robust deviation about the centre, which is removed because a wrong mount causes a constant pitch at
/// constant travel.
double robust_sigma_rad(std::vector<double>& turns_rad) {
    const double centre = motion::shorth(turns_rad);
    for (double& t : turns_rad) t -= centre;
    return std::max(motion::robust_deviation(turns_rad), sigma_min_rad);
}

/// Makes one Gauss-Newton step and returns its size in rad. Fills `pitches` and `rolls` with the values of
/// the pairs.
double improve(const std::vector<CalibrationPair>& pairs, const motion::AngleMask& unknown, AnglesFit& fit,
               std::vector<double>& pitches, std::vector<double>& rolls) {
    motion::PoseScratch scratch;
    PoseSum sum(std::max(1, static_cast<int>(pairs.size()) / groups_wanted));
    double near = 0, close = 0;
    pitches.clear();
    rolls.clear();
    for (const CalibrationPair& pair : pairs) {
        const SeenPair s = seen(pair, fit.correction_rad);
        const motion::PairFit one =
            motion::fit_pair(s.rays, s.camera, pair.motion, Geometry::MidPoint, fit.pitch_prior, scratch);
        sum.add(one.equations);
        near += one.near_vectors;
        close += one.close_vectors;
        if (one.equations.pairs == 0) continue;
        pitches.push_back(one.pitch_rad);
        rolls.push_back(one.roll_rad);
    }
    const motion::PoseCorrection step = sum.solution(unknown);
    const motion::MountAngles systematic = motion::systematic_sigma_rad(motion::select(sum.total(), unknown));
    const double length = step.correction_rad.norm();
    fit.correction_rad += step.correction_rad * std::min(1.0, step_max_rad / std::max(length, 1e-12));
    fit.sigma_rad = (step.sigma_rad.array().square() + systematic.array().square()).sqrt();
    fit.pairs = sum.pairs();
    fit.agreeing_vectors = close;
    fit.agreeing = near > 0 ? close / near : 0.0;
    return length;
}

}  // namespace

AnglesFit fit_angles(const std::vector<CalibrationPair>& pairs, const motion::MountAngles& start_rad,
                     const motion::AngleMask& unknown) {
    AnglesFit fit;
    fit.correction_rad = start_rad;
    std::vector<double> pitches, rolls;
    for (const bool last : {false, true}) {
        fit.settled = false;
        for (int round = 0; round < rounds_max && !fit.settled; ++round)
            fit.settled = improve(pairs, unknown, fit, pitches, rolls) < settled_rad;
        if (!last) fit.pitch_prior = {robust_sigma_rad(pitches), robust_sigma_rad(rolls)};
    }
    return fit;
}

std::optional<ScaleFit> fit_scale(const std::vector<TravelPiece>& flow, const PoseTrack& odometry) {
    struct Piece {
        double flow_m, odometry_m;
    };
    std::vector<Piece> pieces;
    std::vector<double> ratios;
    for (const TravelPiece& piece : flow) {
        const auto begin = odometry.ground_at(piece.begin_s);
        const auto end = odometry.ground_at(piece.end_s);
        if (!begin || !end) continue;
        const Pose2 way = compose(inverse(*begin), *end);
        const double heading = way.yaw_rad / 2;
        const double forward_m = std::cos(heading) * way.x_m + std::sin(heading) * way.y_m;
        if (std::abs(forward_m) < travel_min_m || piece.forward_m * forward_m <= 0.0) continue;
        pieces.push_back({std::abs(piece.forward_m), std::abs(forward_m)});
        ratios.push_back(forward_m / piece.forward_m);
    }
    if (static_cast<int>(pieces.size()) < scale_pairs_min) return std::nullopt;
    ScaleFit fit;
    fit.ratio = motion::shorth(ratios);
    for (int step = 0; step < 8; ++step) {
        std::vector<double> residuals;
        residuals.reserve(pieces.size());
        for (const Piece& p : pieces) residuals.push_back(p.odometry_m - fit.ratio * p.flow_m);
        std::vector<double> work = residuals;
        const double deviation_m = std::max(motion::robust_deviation(work), 1e-9);
        double flow_m = 0, odometry_m = 0;
        fit.pairs = 0;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const double weight = motion::biweight(residuals[i] / deviation_m);
            flow_m += weight * pieces[i].flow_m;
            odometry_m += weight * pieces[i].odometry_m;
            fit.pairs += weight > 0.0;
        }
        if (fit.pairs < scale_pairs_min) return std::nullopt;
        fit.ratio = odometry_m / flow_m;
        fit.sigma = deviation_m * std::sqrt(fit.pairs) / flow_m;
    }
    return fit;
}

}  // namespace flownav::evaluation
