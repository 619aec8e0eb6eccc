#pragma once

#include <opencv2/core/mat.hpp>

#include "flownav/core/pose2.h"

namespace flownav::sim {

/// Renders one world as one ideal camera on a robot sees it: no noise, blur, vignetting or vibration. Made
/// for a world and a camera; CameraSimulator draws with OpenGL, RayCaster casts rays.
class Renderer {
  public:
    virtual ~Renderer() = default;

    /// Grey image (CV_8U) from `T_world_robot`, `time_s` after the start of the world. Integer pixel
    /// coordinates are pixel centres.
    virtual cv::Mat1b render(const Pose2& T_world_robot, double time_s) = 0;

    /// Exact depth of every pixel's centre along the optical axis: CV_32F, metres, 0 where its ray meets
    /// neither floor nor solid.
    virtual cv::Mat1f depth_m(const Pose2& T_world_robot, double time_s) = 0;

  protected:
    Renderer() = default;
    Renderer(const Renderer&) = default;
    Renderer(Renderer&&) = default;
    Renderer& operator=(const Renderer&) = default;
    Renderer& operator=(Renderer&&) = default;
};

}  // namespace flownav::sim
