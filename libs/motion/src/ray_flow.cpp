#include "flownav/motion/ray_flow.h"

namespace flownav::motion {

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

}  // namespace flownav::motion
