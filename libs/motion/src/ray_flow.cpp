#include "flownav/motion/ray_flow.h"

namespace flownav {

using Eigen::Vector2d;

RayFlow ray_flow(const FlowVector& vector, const RayMapper& reference, const RayMapper& newer,
                 Geometry geometry) {
    return ray_flow(vector, reference.ray(vector.at_px), reference, newer, geometry);
}

RayFlow ray_flow(const FlowVector& vector, const Vector2d& begin, const RayMapper& reference,
                 const RayMapper& newer, Geometry geometry) {
    const Vector2d end = newer.ray(vector.at_px + vector.flow_px);
    return {geometry == Geometry::MidPoint ? Vector2d((begin + end) / 2) : begin, end - begin,
            vector.sigma_px.cwiseProduct(one_pixel(reference.camera()))};
}

Vector2d GroundFlow::operator()(const Vector2d& at) const {
    Vector2d flow = Vector2d::Zero();
    for (int i = 0; i < 3; ++i) {  // the mid-point depends on the vector: three rounds settle it
        const Vector2d mid = at + flow / 2;
        // Eq. (3)
        flow = plane_.ground_inverse_depth(mid) * plane_.e(mid, travel_) + omega_rad_ * plane_.h(mid) +
               pitch_rad_ * PlaneGeometry::p(mid);
    }
    return flow;
}

}  // namespace flownav
