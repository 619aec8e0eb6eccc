#include "flownav/motion/ray_flow.h"

namespace flownav {

using Eigen::Vector2d;

RayFlow ray_flow(const FlowVector& vector, const RayMapper& reference, const RayMapper& newer,
                 Geometry geometry) {
    const Vector2d begin = reference.ray(vector.at_px);
    const Vector2d end = newer.ray(vector.at_px + vector.flow_px);
    return {geometry == Geometry::MidPoint ? Vector2d((begin + end) / 2) : begin, end - begin,
            vector.sigma_px.cwiseProduct(one_pixel(reference.camera()))};
}

Vector2d predicted_ground_flow(const PlaneGeometry& plane, const CameraMount& mount, const Vector2d& at,
                               const MotionPrediction& motion) {
    const Vector2d travel = camera_travel(mount, motion.forward_m, motion.omega_rad, motion.chord_rad);
    Vector2d flow = Vector2d::Zero();
    for (int i = 0; i < 3; ++i) {  // the mid-point depends on the vector: three rounds settle it
        const Vector2d mid = at + flow / 2;
        // Eq. (3)
        flow = plane.ground_inverse_depth(mid) * plane.e(mid, travel) + motion.omega_rad * plane.h(mid) +
               motion.pitch_rad * PlaneGeometry::p(mid);
    }
    return flow;
}

}  // namespace flownav
