#pragma once
#include <Eigen/Core>

namespace flownav {

/// One measured displacement between a reference field and a newer one. It may come from the block matcher,
/// another matcher or a video codec; positions may change from cycle to cycle.
struct FlowVector {
    Eigen::Vector2d at_px = Eigen::Vector2d::Zero();    ///< centre in the reference field, (u, v)
    Eigen::Vector2d flow_px = Eigen::Vector2d::Zero();  ///< from the reference to the newer field
    Eigen::Vector2d sigma_px{0.3, 0.3};                 ///< standard deviation of flow_px in u and v
    double confidence = 0.0;                            ///< 0 (worthless) .. 1 (unambiguous)
    bool valid = false;                                 ///< false: nothing could be measured here
};

/// The same vector on the level camera's normalised plane, ready for equations (3) to (13).
struct RayFlow {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();     ///< (x, y) where e, h and Z are evaluated
    Eigen::Vector2d flow = Eigen::Vector2d::Zero();   ///< (dx, dy)
    Eigen::Vector2d sigma = Eigen::Vector2d::Zero();  ///< standard deviation of dx and dy
};

/// What became of a block in this field, in the order of the decisions.
enum class BlockLabel {
    Unplaced,     ///< its window left the image, or nothing has been measured yet
    Sifted,       ///< the match is ambiguous (confidence too low)
    Eliminated,   ///< Eq. (11): the vector does not point away from the focus of expansion
    Ground,       ///< agrees with the ground plane
    Obstacle,     ///< Eq. (13) holds and neighbours agree
    Moving,       ///< belongs to something that moves by itself
    Unsupported,  ///< Eq. (13) holds but no neighbour agrees
    Unjudged,     ///< consistent, but neither ground nor obstacle can be told (e.g. far, or T unknown)
};

/// The word of a label, as written in files and pictures.
const char* to_string(BlockLabel label);

}  // namespace flownav
