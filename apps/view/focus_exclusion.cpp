#include "focus_exclusion.h"

#include "flownav/core/plane_geometry.h"

namespace flownav::view {

cv::Mat focus_exclusion_mask(const RayMapper& mapper, double focus_exclusion, int cell_px) {
    const CameraModel& camera = mapper.camera();
    const PlaneGeometry plane(camera.mount);
    cv::Mat mask((camera.height_px + cell_px - 1) / cell_px, (camera.width_px + cell_px - 1) / cell_px,
                 CV_8UC1);
    for (int row = 0; row < mask.rows; ++row) {
        for (int column = 0; column < mask.cols; ++column) {
            const Eigen::Vector2d pixel((column + 0.5) * cell_px - 0.5, (row + 0.5) * cell_px - 0.5);
            const bool blind = plane.e(mapper.ray(pixel)).norm() < focus_exclusion;
            mask.at<std::uint8_t>(row, column) = blind ? 255 : 0;
        }
    }
    return mask;
}

}  // namespace flownav::view
