#include "flownav/obstacles/drops.h"

#include <algorithm>
#include <cmath>

#include "set_obstacle.h"

namespace flownav::obstacles {
namespace {

constexpr std::size_t blocks_min = 4;
constexpr double beside_m = 0.175;        // of the middle of the strip
constexpr double depth_m = 0.6;           // within which the blocks lie
constexpr double behind_rim_min_m = 0.2;  // the nearest short block lies behind the rim by so much
constexpr double behind_rim_max_m = 0.6;

/// Nearest of blocks_min distances within depth_m; 0: there are not so many. Needs them sorted.
double nearest_group_m(const std::vector<double>& forward_m) {
    for (std::size_t i = 0; i + blocks_min <= forward_m.size(); ++i)
        if (forward_m[i + blocks_min - 1] - forward_m[i] <= depth_m) return forward_m[i];
    return 0.0;
}

}  // namespace

void mark_drops(const std::vector<Eigen::Vector2d>& short_blocks, std::vector<double>& buffer,
                ContactScan& scan) {
    if (scan.gate != ContactGate::Open || short_blocks.size() < blocks_min) return;
    for (int i = 0; i < static_cast<int>(scan.strips.size()); ++i) {
        buffer.clear();
        for (const Eigen::Vector2d& p : short_blocks)
            if (std::abs(p.y() - middle_tangent(scan, i) * p.x()) <= beside_m) buffer.push_back(p.x());
        std::sort(buffer.begin(), buffer.end());
        const double group_m = nearest_group_m(buffer);
        if (group_m <= 0.0) continue;
        ContactStrip& strip = scan.strips[static_cast<std::size_t>(i)];
        const double rim_max_m = group_m - 0.5 * behind_rim_min_m;
        const double rim_min_m = std::max(0.5 * group_m, group_m - behind_rim_max_m);
        const double rim_m = std::clamp(strip.free_m, rim_min_m, std::max(rim_min_m, rim_max_m));
        if (strip.kind == BeamKind::Obstacle && strip.near_m <= rim_m) continue;
        set_obstacle(strip, BeamCause::Drop, rim_m, rim_min_m, rim_max_m);
        strip.free_m = std::min(strip.free_m, rim_m);
    }
}

}  // namespace flownav::obstacles
