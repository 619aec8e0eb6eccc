#pragma once
#include <vector>

#include "flownav/motion/estimate_motion.h"

namespace flownav::motion {

/// A candidate for the rotation between the reference and the newer field.
struct RotationHypothesis {
    double omega_rad = 0.0;
    double pitch_rad = 0.0;
};

/// Signed residual of an equation for a rotation, in standard deviations of its vector.
inline double residual(const MotionScratch::RotationEquation& row, const RotationHypothesis& turn) {
    return row.measured - row.turn * turn.omega_rad - row.pitch * turn.pitch_rad;
}

/// Fills scratch.inlier_counts from scratch.rotation_equations and divides the area of the vectors into 8 x 6
/// cells.
void prepare_inlier_counts(MotionScratch& scratch);

/// Support of a rotation. A cell counts when more than half of its vectors, and at least two, agree. Counting
/// cells keeps many vectors on one small object from outweighing few vectors over the whole image.
struct Support {
    int cells = 0;      ///< cells that agree
    int all_cells = 0;  ///< cells with at least two vectors
    int vectors = 0;

    double share() const { return all_cells > 0 ? static_cast<double>(cells) / all_cells : 0.0; }
};

/// Counts the support of a rotation; needs prepare_inlier_counts(). A vector agrees when its distance across
/// e is below `lambda_px` and below 3 of its standard deviations or 0.4 px, whichever is larger.
Support support_of(MotionScratch::InlierCounts& inlier_counts, const RotationHypothesis& turn,
                   double lambda_px);

struct Consensus {
    RotationHypothesis turn;
    Support support;
    bool as_predicted = false;  ///< the turn lies within the prediction's tolerance
};

/// True when the support of a predicted rotation is so large that no rotation outside the prediction's
/// tolerance can win against it in find_consensus(). Another rotation within the tolerance may have more
/// support; fit_rotation() converges to the same rotation from both.
bool outvotes_every_other_motion(const Consensus& predicted);

/// Returns the rotation with the largest support among the prediction, the background of [S]
/// (`background_rad`) and the rotations of pairs of vectors. A rotation within the prediction's tolerance
/// wins against others with up to twice its support, so that a large dynamic object is not taken for a turn
/// of the robot.
Consensus find_consensus(MotionScratch& scratch, double background_rad, const MotionPrediction& prediction,
                         const MotionParams& params);

}  // namespace flownav::motion
