#pragma once
#include <array>
#include <vector>

namespace flownav {

enum class BeamKind {
    Unknown,   ///< this bearing was not seen: NOT free
    Free,      ///< floor was confirmed up to range_m; beyond it is unknown
    Obstacle,  ///< the nearest obstacle stands at range_m
};

/// How an obstacle was found.
enum class BeamCause {
    None,    ///< the beam is not an obstacle
    Blocks,  ///< points of blocks, Eq. (13)
    Votes,   ///< pixels that do not move as the floor does
    Wall,    ///< a surface without edges from above the horizon down to its first edge
    Drop,    ///< the floor ends: what is seen there lies below it
};

/// All causes, in the order of BeamCause.
constexpr std::array<BeamCause, 5> all_beam_causes = {BeamCause::None, BeamCause::Blocks, BeamCause::Votes,
                                                      BeamCause::Wall, BeamCause::Drop};

/// Name of a kind and of a cause, as written to files.
const char* to_string(BeamKind kind);
const char* to_string(BeamCause cause);

struct Beam {
    BeamKind kind = BeamKind::Unknown;
    double range_m = 0.0;
    BeamCause cause = BeamCause::None;
    double near_m = 0.0;  ///< of an obstacle: it stands between near_m
    double far_m = 0.0;   ///< and far_m
};

/// A horizontal scan about the robot's axis. Beam i covers the bearings
/// first_bearing_rad + i * step_rad +- step_rad / 2 (> 0 to the left).
struct VirtualScan {
    double first_bearing_rad = 0.0;
    double step_rad = 0.0;
    std::vector<Beam> beams;
};

}  // namespace flownav
