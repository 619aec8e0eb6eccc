#pragma once

#include <cmath>
#include <vector>

#include "flownav/core/pose2.h"
#include "flownav/math/units.h"
#include "flownav/obstacles/level_image.h"

namespace flownav::testing {

/// An upright screen of one colour across the x axis of the world, from the floor up.
struct Screen {
    double x_m = 2.0;
    double left_m = 0.0;  ///< of its middle
    double width_m = 0.2;
    double height_m = 0.5;
    double grey = 60.0;
};

/// A textured floor z = 0 with screens, drawn into level images. World frame: x forward, y left, z up.
struct LevelWorld {
    double contrast = 40.0;  ///< of the floor's waves
    double grain = 0.0;      ///< largest deviation of squares of 2 cm from them
    std::vector<Screen> screens;

    double floor_grey(double x_m, double y_m) const {
        const double waves = std::sin(9 * x_m + 5 * y_m) + std::sin(13 * y_m - 4 * x_m) +
                             std::sin(7 * (x_m + y_m)) + std::sin(6 * x_m - 17 * y_m);
        return 128.0 + contrast / 2 * waves + grain * chance(x_m, y_m);
    }

    /// -1 .. 1, one number a square.
    static double chance(double x_m, double y_m) {
        const double seed = std::floor(x_m / 0.02) * 12.9898 + std::floor(y_m / 0.02) * 78.233;
        const double number = std::sin(seed) * 43758.5453;
        return 2.0 * (number - std::floor(number)) - 1.0;
    }
};

/// Pose of a camera in a LevelWorld.
struct LevelView {
    Pose2 T_world_camera;
    double pitch_rad = 18.0 * degree_rad;  ///< > 0 looks down
    double roll_rad = 0.0;                 ///< of the scene, > 0 clockwise
    double height_m = 0.6;
};

/// The camera of the pictures, as calibrated: 320x240, 90 degrees wide, 0.6 m high, 18 degrees down.
inline obstacles::LevelCamera level_camera() {
    const double pitch_rad = 18.0 * degree_rad;
    return {160.0, 160.0, 159.5, 119.5, std::cos(pitch_rad), std::sin(pitch_rad), 0.6};
}

/// Draws without noise.
inline obstacles::LevelImage draw(const LevelWorld& world, const LevelView& view) {
    obstacles::LevelImage image;
    image.width = 320;
    image.height = 240;
    image.camera = level_camera();
    image.grey.resize(320 * 240);
    const double c = std::cos(view.T_world_camera.yaw_rad);
    const double s = std::sin(view.T_world_camera.yaw_rad);
    const double cr = std::cos(view.roll_rad);
    const double sr = std::sin(view.roll_rad);
    const double a = std::cos(view.pitch_rad);
    const double b = std::sin(view.pitch_rad);
    for (int v = 0; v < 240; ++v) {
        for (int u = 0; u < 320; ++u) {
            const double px = (u - image.camera.cx_px) / image.camera.fx_px;
            const double py = (v - image.camera.cy_px) / image.camera.fy_px;
            // Into level axes, then the roll about the heading taken out.
            const double right0 = px;
            const double down0 = a * py + b;
            const double forward = a - b * py;
            const double right = cr * right0 + sr * down0;
            const double down = -sr * right0 + cr * down0;
            const double dx = c * forward + s * right;  // world, right is -left
            const double dy = s * forward - c * right;
            double grey = 215.0;
            double nearest = 1e9;
            if (down > 1e-6) {
                nearest = view.height_m / down;
                grey = world.floor_grey(view.T_world_camera.x_m + nearest * dx,
                                        view.T_world_camera.y_m + nearest * dy);
            }
            for (const Screen& screen : world.screens) {
                const double t = (screen.x_m - view.T_world_camera.x_m) / dx;
                const double y = view.T_world_camera.y_m + t * dy;
                const double z = view.height_m - t * down;
                if (!(t > 0.0) || t >= nearest || z < 0.0 || z > screen.height_m ||
                    std::abs(y - screen.left_m) > screen.width_m / 2)
                    continue;
                nearest = t;
                grey = screen.grey;
            }
            image.row(v)[u] = static_cast<float>(grey);
        }
    }
    return image;
}

}  // namespace flownav::testing
