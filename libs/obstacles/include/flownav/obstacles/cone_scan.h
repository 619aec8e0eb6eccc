#pragma once
#include <array>
#include <optional>
#include <vector>

#include "flownav/core/contact_scan.h"
#include "flownav/core/pose2.h"
#include "flownav/obstacles/contact_votes.h"

namespace flownav::obstacles {

constexpr double cone_tangent = 0.12;   ///< half the width of the cone straight ahead, as tangent
constexpr double cone_travel_m = 0.54;  ///< shortest way between the images of a long pair

/// Votes of one long pair for the strips of the cone, from the nearest cell to the farthest.
struct ConeVotes {
    struct Part {
        std::vector<float> score;  ///< cell by cell, cone_strips each
        double usual = 0.0;        ///< 30th percentile over the strips at the sides of their best scores
    };
    Pose2 T_start_robot;
    std::vector<double> forward_m;  ///< of each cell
    int first = 0;                  ///< strip i of the cone covers the tangents (first + i) * step and up
    int strips = 0;
    Part steep;
    Part all;
};

/// A thing straight ahead that was seen in two scans, held by dead reckoning.
struct HeldThing {
    Eigen::Vector2d place_m = Eigen::Vector2d::Zero();  ///< frame of T_start_robot
    double near_m = 0.0;                                ///< the place may be nearer by near_m
    double far_m = 0.0;                                 ///< or farther by far_m
    Pose2 seen_from;
};

/// Memory of the scan straight ahead.
struct ConeMemory {
    static constexpr int most = 6;
    std::array<ConeVotes, most> votes;
    int newest = 0;
    int size = 0;
    std::optional<HeldThing> candidate;  ///< of the last scan
    std::optional<HeldThing> held;
    // Buffers.
    std::vector<float> sums;
    std::vector<float> sides;
};

/// Strips whose votes a long pair needs: the cone and the sides that tell how much floor alone is voted for.
StripRange side_strips(int first, int strips);

/// Makes room for the votes of a new pair, the newest.
ConeVotes& push_cone_votes(ConeMemory& memory, const Pose2& T_start_robot);

/// Forgets the pairs and what was seen in them.
void forget_pairs(ConeMemory& memory);

/// Room for pairs of so many cells, so that none allocates.
void reserve(ConeMemory& memory, std::size_t cells);

/// Copies the scores of the cone and measures those of the sides. `sides`: buffer.
void take_votes(const LevelImage& newer, const ContactVotes& votes, std::vector<float>& sides,
                ConeVotes& out);

/// With a new pair, adds up the votes of the last 0.7 m at each place of the cone and holds what stands out.
/// Enters what is held, up to `range_max_m`, as an obstacle.
void decide_cone(ConeMemory& memory, const Pose2& T_start_robot, bool has_new_pair, double range_max_m,
                 ContactScan& out);

}  // namespace flownav::obstacles
