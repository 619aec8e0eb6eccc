#pragma once

#include "flownav/sim/renderer.h"
#include "flownav/sim/truth.h"

namespace flownav::sim {

/// Mean light of every pixel as the view sees the world: CV_32F, grey levels, not clamped. Deterministic: the
/// same arguments give the same bytes with any number of threads.
cv::Mat1f cast_light(const World& world, const View& view);

/// Renders by casting rays at the exact shapes, with textures computed from noise: shares no code with the GL
/// renderer. Draws waves and shading of the world, and every camera that RayMapper can invert.
class RayCaster final : public Renderer {
  public:
    RayCaster(World world, const CameraModel& camera);

    cv::Mat1b render(const Pose2& T_world_robot, double time_s) override;
    cv::Mat1f depth_m(const Pose2& T_world_robot, double time_s) override;

  private:
    World world_;
    CameraModel camera_;
};

}  // namespace flownav::sim
