#pragma once
#include <Eigen/Core>

namespace flownav {

/// Measured displacement between a reference field and a newer one, from the block matcher, another matcher
/// or a video codec. Positions may change from cycle to cycle.
struct FlowVector {
    Eigen::Vector2d at_px = Eigen::Vector2d::Zero();    ///< centre in the reference field, (u, v)
    Eigen::Vector2d flow_px = Eigen::Vector2d::Zero();  ///< from reference to newer field
    Eigen::Vector2d sigma_px{0.3, 0.3};                 ///< standard deviation of flow_px in u and v
    double confidence = 0.0;                            ///< 0 (worthless) .. 1 (unambiguous)
    bool valid = false;                                 ///< false: no displacement could be measured
};

/// A flow vector on the level camera's normalised plane, the input of equations (3) to (13).
struct RayFlow {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();     ///< point (x, y) where e, h and Z are evaluated
    Eigen::Vector2d flow = Eigen::Vector2d::Zero();   ///< (dx, dy)
    Eigen::Vector2d sigma = Eigen::Vector2d::Zero();  ///< standard deviation of dx and dy
};

/// Result of a block in one field, in the order of the decisions.
enum class BlockLabel {
    Unplaced,     ///< its search window left the image, or it has no measurement yet
    Sifted,       ///< the match is ambiguous (confidence too low)
    Eliminated,   ///< Eq. (11): the vector does not point away from the focus of expansion
    Ground,       ///< agrees with the ground plane
    Obstacle,     ///< Eq. (13) holds and enough neighbours agree
    Moving,       ///< part of a dynamic object
    Unsupported,  ///< Eq. (13) holds but too few neighbours agree
    Unjudged,     ///< passes (11), but ground and obstacle cannot be told apart (e.g. far away, or T unknown)
};

/// Name of a label, as written to files and pictures.
const char* to_string(BlockLabel label);

}  // namespace flownav
