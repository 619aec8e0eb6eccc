#include "short_blocks.h"

#include "flownav/core/plane_geometry.h"
#include "flownav/obstacles/drops.h"

namespace flownav::pipeline {

void find_short_blocks(const EndedCycle& cycle, ShortBlocks& out) {
    out.floor_points_m.clear();
    const CameraMount& mount = cycle.reference.field.camera.mount;
    const PlaneGeometry plane(mount);
    const Pose2 T_end_reference = inverse(pose_after(cycle.images.back().motion));
    for (std::size_t i = 0; i < cycle.blocks.size(); ++i) {
        const BlockRecord& block = cycle.blocks[i];
        if (block.image_of_cycle == 0 || block.label != BlockLabel::Unjudged ||
            block.excess_px > obstacles::drop_excess_px)
            continue;
        const Eigen::Vector2d at = cycle.reference.mapper.ray(block.vector.at_px);
        const double inverse_depth = plane.ground_inverse_depth(at);
        if (inverse_depth <= 0.0) continue;
        const double forward_m = (plane.a - plane.b * at.y()) / inverse_depth;
        const double right_m = at.x() / inverse_depth;
        const Eigen::Vector2d p =
            transform(T_end_reference, {mount.forward_m + forward_m, mount.left_m - right_m});
        const Eigen::Vector2d seen(p.x() - mount.forward_m, mount.left_m - p.y());
        if (seen.x() > 0.0 && seen.x() < obstacles::drop_range_m) out.floor_points_m.push_back(seen);
    }
}

}  // namespace flownav::pipeline
