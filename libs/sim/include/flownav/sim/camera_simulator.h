#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>

#include "flownav/core/field.h"
#include "flownav/core/pose2.h"
#include "flownav/sim/field_camera.h"
#include "flownav/sim/renderer.h"
#include "flownav/sim/world.h"

namespace flownav::sim {

/// Effects of lens, chip and a shaking robot on every image, drawn from the seed and the image's number.
struct CameraEffects {
    double gain = 1.0;                 ///< exposure; 1 leaves the greys of the world
    double exposure_step = 0.0;        ///< share by which auto exposure steps every 12 to 24 images
    double vignetting = 0.0;           ///< share of light lost in the corners, 0..1
    double blur_px = 0.0;              ///< sigma of the lens
    double noise_sigma = 2.0;          ///< grey levels
    double pitch_vibration_deg = 0.0;  ///< rms, added to the true pose and unknown to the calibration
    double roll_vibration_deg = 0.0;   ///< the same
    std::uint64_t seed = 1;
};

struct CameraSimParams {
    CameraModel camera;       ///< of a whole frame, also when it is interlaced
    bool interlaced = false;  ///< fields of alternating parity, even image numbers the top one
    double rate_hz = 25.0;    ///< of fields; for callers of take(), which does not use it
    int supersampling = 2;    ///< samples a pixel, in either direction
    CameraEffects effects;
};

/// The camera of one image: `frame`, or its field when it is interlaced.
CameraModel image_camera(const CameraSimParams& params, int image);

/// Renders with OpenGL, without a display (EGL; Mesa's software renderer will do). The same arguments give
/// the same bytes on one machine. To be used in the thread that made it. Throws std::runtime_error when there
/// is no EGL, std::invalid_argument when params are out of range or the world has waves.
class CameraSimulator final : public Renderer {
  public:
    CameraSimulator(const World& world, const CameraSimParams& params);
    ~CameraSimulator() override;
    CameraSimulator(CameraSimulator&&) noexcept;
    CameraSimulator& operator=(CameraSimulator&&) noexcept;

    /// Image number `image` (>= 0; it picks the parity and seeds the effects), taken at `time_s` after the
    /// start of the world. The field owns its pixels and carries the calibrated camera, without vibration.
    Field take(int image, const Pose2& T_world_robot, double time_s);

    /// By the camera of image 0, without effects.
    cv::Mat1b render(const Pose2& T_world_robot, double time_s) override;

    /// By the camera of image 0. Of the exact shapes, not of their meshes.
    cv::Mat1f depth_m(const Pose2& T_world_robot, double time_s) override;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace flownav::sim
