#include "consensus.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flownav::motion {
namespace {

constexpr int columns = 8;
constexpr int lines = 6;
constexpr std::size_t cells = std::size_t{columns} * lines;
constexpr int cell_inliers_min = 2;
constexpr int pairs_tried = 40;
constexpr double continuity_bonus =
    2.0;  // a rotation within the prediction's tolerance needs only half the support
constexpr double determinant_min = 1e-3;  // relative; below, the two equations are nearly parallel

bool better(const Support& a, const Support& b) {
    return a.cells != b.cells ? a.cells > b.cells : a.vectors > b.vectors;
}

/// The best rotation evaluated so far, kept separately for rotations within the prediction's tolerance and
/// for all others.
struct HypothesisSet {
    MotionScratch& scratch;
    const MotionPrediction& prediction;
    double lambda_px;
    Consensus continuing, other;

    void evaluate(const RotationHypothesis& turn) {
        const bool continues =
            std::abs(turn.omega_rad - prediction.omega_rad) <= prediction.omega_tolerance_rad;
        Consensus& best_so_far = continues ? continuing : other;
        const Support support = support_of(scratch.inlier_counts, turn, lambda_px);
        if (better(support, best_so_far.support)) best_so_far = {turn, support, continues};
    }
    const Consensus& best() const {
        return continuity_bonus * continuing.support.cells >= other.support.cells ? continuing : other;
    }
};

/// Solves the equations of two vectors for the rotation; MotionModel::Yaw uses the first one only. Returns
/// false when they do not determine it.
bool turn_of(const MotionScratch::RotationEquation& p, const MotionScratch::RotationEquation& q,
             MotionModel model, RotationHypothesis& turn) {
    if (model == MotionModel::Yaw) {
        turn = {p.measured / p.turn, 0.0};
        return p.turn != 0.0;
    }
    const double determinant = p.turn * q.pitch - q.turn * p.pitch;
    if (std::abs(determinant) < determinant_min * (std::abs(p.turn * q.pitch) + std::abs(q.turn * p.pitch)))
        return false;
    turn = {(p.measured * q.pitch - q.measured * p.pitch) / determinant,
            (p.turn * q.measured - q.turn * p.measured) / determinant};
    return true;
}

/// Evaluates pairs of equations, spread evenly over all pairs by a fixed low-discrepancy sequence.
void evaluate_pairs(HypothesisSet& hypotheses, MotionModel model) {
    constexpr double plastic = 1.32471795724474602596;  // x^3 = x + 1
    const auto n = static_cast<double>(hypotheses.scratch.rotation_equations.size());
    const auto pick = [&](double x) {
        return hypotheses.scratch.rotation_equations[static_cast<std::size_t>((x - std::floor(x)) * n)];
    };
    for (int k = 1; k <= pairs_tried; ++k) {
        RotationHypothesis turn;
        if (turn_of(pick(k / plastic), pick(k / (plastic * plastic)), model, turn)) hypotheses.evaluate(turn);
    }
}

}  // namespace

void prepare_inlier_counts(MotionScratch& scratch) {
    auto& rows = scratch.rotation_equations;
    auto& inlier_counts = scratch.inlier_counts;
    const std::size_t n = rows.size();
    for (auto* numbers :
         {&inlier_counts.turn, &inlier_counts.pitch, &inlier_counts.measured, &inlier_counts.deviation_px})
        numbers->resize(n);
    inlier_counts.cell.resize(n);
    inlier_counts.agrees.resize(n);
    inlier_counts.of_cell.assign(cells, 0);
    if (rows.empty()) return;
    Eigen::Vector2d low = rows.front().at;
    Eigen::Vector2d high = rows.front().at;
    for (const auto& row : rows) {
        low = low.cwiseMin(row.at);
        high = high.cwiseMax(row.at);
    }
    const Eigen::Vector2d size = (high - low).cwiseMax(1e-9);
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector2d share = (rows[i].at - low).cwiseQuotient(size);
        inlier_counts.cell[i] = std::min(columns - 1, static_cast<int>(share.x() * columns)) +
                                columns * std::min(lines - 1, static_cast<int>(share.y() * lines));
        ++inlier_counts.of_cell[inlier_counts.cell[i]];
        inlier_counts.turn[i] = rows[i].turn;
        inlier_counts.pitch[i] = rows[i].pitch;
        inlier_counts.measured[i] = rows[i].measured;
        inlier_counts.deviation_px[i] = rows[i].deviation_px;
    }
}

Support support_of(MotionScratch::InlierCounts& inlier_counts, const RotationHypothesis& turn,
                   double lambda_px) {
    constexpr double vote_px = 0.4;
    constexpr double vote_deviations = 3.0;
    const std::size_t n = inlier_counts.turn.size();
    for (std::size_t i = 0; i < n; ++i) {
        const double r = std::abs(inlier_counts.measured[i] - inlier_counts.turn[i] * turn.omega_rad -
                                  inlier_counts.pitch[i] * turn.pitch_rad);
        const double r_px = r * inlier_counts.deviation_px[i];
        inlier_counts.agrees[i] = static_cast<int>(r_px < lambda_px) &
                                  (static_cast<int>(r < vote_deviations) | static_cast<int>(r_px < vote_px));
    }
    std::array<int, cells> agreeing{};
    Support s;
    for (std::size_t i = 0; i < n; ++i) {
        agreeing[inlier_counts.cell[i]] += inlier_counts.agrees[i];
        s.vectors += inlier_counts.agrees[i];
    }
    for (std::size_t i = 0; i < cells; ++i) {
        s.all_cells += inlier_counts.of_cell[i] >= cell_inliers_min;
        s.cells += agreeing[i] >= cell_inliers_min && 2 * agreeing[i] > inlier_counts.of_cell[i];
    }
    return s;
}

bool outvotes_every_other_motion(const Consensus& predicted) {
    const Support& s = predicted.support;
    return s.cells > 0 && continuity_bonus * s.cells >= s.all_cells;
}

Consensus find_consensus(MotionScratch& scratch, double background_rad, const MotionPrediction& prediction,
                         const MotionParams& params) {
    HypothesisSet hypotheses{scratch, prediction, params.lambda_px, {}, {}};
    const double pitch_rad = params.model == MotionModel::YawPitch ? prediction.pitch_rad : 0.0;
    hypotheses.continuing = {{prediction.omega_rad, pitch_rad}, {}, true};
    hypotheses.other = {{background_rad, 0.0}, {}, false};
    hypotheses.evaluate({prediction.omega_rad, pitch_rad});
    hypotheses.evaluate({background_rad, pitch_rad});
    hypotheses.evaluate({background_rad, 0.0});
    if (!scratch.rotation_equations.empty()) evaluate_pairs(hypotheses, params.model);
    return hypotheses.best();
}

}  // namespace flownav::motion
