#pragma once
#include <vector>

#include "flownav/motion/estimate_motion.h"

namespace flownav::motion {

/// A rotation that is tried.
struct RotationHypothesis {
    double omega_rad = 0.0;
    double pitch_rad = 0.0;
};

/// How many standard deviations the vector of a row is away from a rotation.
inline double residual(const MotionScratch::RotationEquation& row, const RotationHypothesis& turn) {
    return row.measured - row.turn * turn.omega_rad - row.pitch * turn.pitch_rad;
}

/// Divides the image into 8 x 6 cells, and makes a vote of every row.
void prepare_inlier_counts(MotionScratch& scratch);

/// Over how much of the image the vectors agree with a rotation. A cell counts when most of its vectors, and
/// two at least, agree: many vectors on something close together weigh no more than few all over.
struct Support {
    int cells = 0;      ///< that agree
    int all_cells = 0;  ///< that have two vectors or more
    int vectors = 0;

    double share() const { return all_cells > 0 ? static_cast<double>(cells) / all_cells : 0.0; }
};

/// After prepare_inlier_counts(). A vector agrees with a rotation within its own error, or what the method
/// itself errs, and within lambda, across e.
Support support_of(MotionScratch::InlierCounts& inlier_counts, const RotationHypothesis& turn,
                   double lambda_px);

struct Consensus {
    RotationHypothesis turn;
    Support support;
    bool as_predicted = false;  ///< within the prediction's tolerance
};

/// True for a predicted rotation with so much support that no rotation outside the prediction's tolerance
/// could win against it in find_consensus(). Another one within the tolerance could; fit_rotation() comes to
/// the same rotation from either.
bool outvotes_every_other_motion(const Consensus& predicted);

/// The rotation to start from: the one with the widest support among the predicted one, the background of
/// [S] and the rotations that pairs of vectors stand for. A rotation as predicted wins against another with
/// up to twice its support: what moves across a large part of the view does not turn the robot.
Consensus find_consensus(MotionScratch& scratch, double background_rad, const MotionPrediction& prediction,
                         const MotionParams& params);

}  // namespace flownav::motion
