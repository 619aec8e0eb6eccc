#include <algorithm>
#include <cmath>
#include <optional>

#include "flownav/core/plane_geometry.h"
#include "flownav/flow/kernel.h"
#include "lidar_score.h"

namespace flownav::fidelity {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double looks_px = 6.0;  // returns within this distance of the centre of a block belong to it
constexpr std::size_t returns_min = 3;
constexpr double road_m = 0.1;
constexpr double surely_px = 0.5;  // margin beyond tau

struct Seen {
    Looks looks = Looks::Elsewhere;
    Vector3d at_m = Vector3d::Zero();  ///< the return with the median depth
};

Seen seen_by(const Vector2d& centre_px, const std::vector<std::pair<Vector2d, Vector3d>>& returns) {
    std::vector<Vector3d> near_m;
    for (const auto& [pixel_px, at_m] : returns)
        if ((pixel_px - centre_px).lpNorm<Eigen::Infinity>() <= looks_px) near_m.push_back(at_m);
    if (near_m.size() < returns_min) return {};
    std::sort(near_m.begin(), near_m.end(), [](const auto& p, const auto& q) { return p.x() < q.x(); });
    const bool one_depth = near_m.back().x() - near_m.front().x() < 0.2 * near_m.back().x();
    const Vector3d middle_m = near_m[near_m.size() / 2];
    const auto all = [&](const auto& is) { return std::all_of(near_m.begin(), near_m.end(), is); };
    if (all([](const Vector3d& p) { return std::abs(p.z()) < road_m; })) return {Looks::AtRoad, middle_m};
    if (one_depth && all([](const Vector3d& p) { return p.z() > obstacle_low_m && p.z() < obstacle_high_m; }))
        return {Looks::AtObstacle, middle_m};
    return {};
}

/// Flow of a static point at `at_m`, pixels.
Vector2d still_flow_px(const RayMapper& mapper, const Vector3d& at_m, const EgoMotion& motion) {
    const Pose2 T_reference_now = along_arc(motion.omega_rad, motion.forward_m);
    Vector3d now_m = at_m;
    now_m.head<2>() = transform(inverse(T_reference_now), at_m.head<2>());
    return project(mapper, now_m) - project(mapper, at_m);
}

/// Excess of the flow along e over the flow of the ground behind it, pixels: the left side of (13).
double excess_px(const RayMapper& mapper, const Vector2d& centre_px, const Vector3d& at_m,
                 const EgoMotion& motion) {
    const CameraModel& camera = mapper.camera();
    const PlaneGeometry plane(camera.mount);
    const Vector2d at = mapper.ray(centre_px);
    const Vector2d e = plane.e(at);
    const double depth_m = (robot_from_level(camera.mount).inverse() * at_m).z();
    const double excess = motion.forward_m * (1.0 / depth_m - plane.ground_inverse_depth(at)) * e.norm();
    return excess * e.norm() / deviation_of_dot(e, one_pixel(camera));
}

}  // namespace

void LidarJudge::see_blocks(const pipeline::Step& step, const std::vector<Vector3d>& scan_m) {
    std::vector<std::pair<Vector2d, Vector3d>> returns;
    returns.reserve(scan_m.size());
    for (const Vector3d& at_m : scan_m) returns.emplace_back(project(mapper_, at_m), at_m);
    for (std::size_t i = 0; i < layout_.size() && i < step.blocks.size(); ++i) {
        const Vector2d centre_px = layout_.centre_px[i];
        const Seen seen = seen_by(centre_px, returns);
        const pipeline::BlockRecord& block = step.blocks[i];
        Labels& labels = score_.labels[seen.looks];
        ++labels.all[block.label];
        if (seen.looks == Looks::Elsewhere) continue;
        const double surely = config_.pipeline.obstacles.tau_px + surely_px;
        if (excess_px(mapper_, centre_px, seen.at_m, step.motion) < surely) continue;
        ++labels.telling[block.label];
        const Vector2d off_px = still_flow_px(mapper_, seen.at_m, step.motion) - block.predicted_px;
        if (off_px.minCoeff() < flow::search_min || off_px.maxCoeff() > flow::search_max)
            ++labels.beyond[block.label];
    }
}

}  // namespace flownav::fidelity
