#pragma once
#include <vector>

#include "flownav/core/camera_model.h"
#include "flownav/core/image_view.h"

namespace flownav::obstacles {

/// Pinhole camera of a LevelImage: no lens, no roll and no yaw, the pitch of the mount.
struct LevelCamera {
    double fx_px = 1.0;
    double fy_px = 1.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    double a = 1.0;  ///< cosine of the pitch
    double b = 0.0;  ///< sine of the pitch
    double height_m = 1.0;

    /// Tangent of the angle below the horizon of row `v`; > 0 below. The same in every column.
    double below_horizon(double v) const {
        const double y = (v - cy_px) / fy_px;
        return (a * y + b) / (a - b * y);
    }
    /// Row at which the tangent below the horizon is `tangent`; inverse of below_horizon().
    double row_of(double tangent) const { return cy_px + fy_px * (a * tangent - b) / (a + b * tangent); }
    /// Forward distance of the floor in row `v`, from the camera; only below the horizon.
    double floor_m(double v) const { return height_m / below_horizon(v); }
    /// Forward part of the ray of row `v` whose optical part is 1.
    double forward_of_ray(double v) const { return a - b * (v - cy_px) / fy_px; }
    /// Column of the tangent `right` of the angle to the right of the heading, in row `v`.
    double column_of(double right, double v) const { return cx_px + fx_px * right * forward_of_ray(v); }
};

/// An image at half resolution as LevelCamera takes it, brightness in grey levels, with the fall-off of the
/// lens taken out. NaN where the camera did not look.
struct LevelImage {
    int width = 0;
    int height = 0;
    double vignetting = 0.0;  ///< share of brightness lost at the corner of the image that was taken out
    LevelCamera camera;
    std::vector<float> grey;

    const float* row(int v) const { return grey.data() + static_cast<std::ptrdiff_t>(v) * width; }
    float* row(int v) { return grey.data() + static_cast<std::ptrdiff_t>(v) * width; }
};

/// Mapping from a camera's images to level images; empty for a camera without lens, roll and yaw.
class LevelMapping {
  public:
    LevelMapping() = default;
    explicit LevelMapping(const RayMapper& mapper);

    /// Writes the level image of `image`, taken by `mapper`'s camera. Allocates only when the size changes.
    void apply(const ImageView& image, const RayMapper& mapper, LevelImage& out);

  private:
    struct Sample {
        int index = -1;  ///< of the upper left one of four pixels; -1: outside
        float x = 0.0F;  ///< share of the right pixels
        float y = 0.0F;  ///< share of the lower pixels
    };

    std::vector<Sample> samples_;
    std::vector<float> half_;
};

/// Takes out the fall-off of a lens that loses the share `vignetting` of the brightness at the corner of the
/// image, in place of what was taken out before.
void take_out_vignetting(LevelImage& image, double vignetting);

/// Half of the distance between opposite corners, pixels: the unit of the radius in which fall-off is learnt.
double corner_radius_px(const LevelImage& image);

}  // namespace flownav::obstacles
