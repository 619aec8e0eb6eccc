#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/math/units.h"
#include "flownav/testing/camera.h"
#include "flownav/testing/effects.h"
#include "flownav/testing/truth.h"

namespace flownav::testing {

enum class SceneKind : std::uint8_t {
    Free,       ///< straight over an empty floor
    Straight,   ///< straight between boxes, poles, chairs and drums
    SCurve,     ///< an S through the same
    Turns,      ///< straight pieces and turns
    Corridor,   ///< a gentle weave through a corridor with boxes and poles
    StopAndGo,  ///< straight, standing still again and again
    Mover,      ///< straight, with a large box crossing ahead
    Loop,       ///< once around a railing and a chair: 16.3 m
};

constexpr std::array<SceneKind, 8> all_scene_kinds = {
    SceneKind::Free,     SceneKind::Straight,  SceneKind::SCurve, SceneKind::Turns,
    SceneKind::Corridor, SceneKind::StopAndGo, SceneKind::Mover,  SceneKind::Loop};

const char* to_string(SceneKind kind);
std::optional<SceneKind> scene_kind(const std::string& name);

/// The floor of a name: carpet, tiles, lino, plain, stoneware or marbled.
std::optional<Surface> floor_surface(const std::string& name);

/// The box that crosses the way in SceneKind::Mover. It keeps ahead of the robot.
struct MoverOptions {
    double speed_mps = 0.25;  ///< across, to the right
    double width_m = 1.5;
    double start_left_m = 1.3;  ///< of the robot's line, its middle
    double ahead_m = 1.95;      ///< of the robot, its middle
};

struct SceneOptions {
    SceneKind kind = SceneKind::SCurve;
    std::uint64_t seed = 1;
    int images = 120;
    double rate_hz = 25.0;
    double speed_mps = 0.4;
    double turn_radps = 30.0 * degree_rad;  ///< fastest turn of SCurve and Turns
    Surface floor = Surface::Carpet;
    CameraModel camera = standard_camera();  ///< of a frame
    bool interlaced = false;                 ///< fields of alternating parity, the top one first
    bool rails = false;                      ///< railings along the way, too
    bool near_boxes = false;                 ///< boxes 0.28 m beside the path; other objects keep 0.5 m
    double floor_waves_m = 0.0;              ///< bumps of the floor, up and down; the robot rides on them
    MoverOptions mover;
    CameraEffects effects;  ///< its seed is made from the scene's
};

/// A drive through a world. Image i is taken at poses[i], i / rate_hz seconds after the start.
struct Scene {
    SceneOptions options;
    World world;
    std::vector<Pose2> poses;  ///< of the robot in the world

    int images() const { return static_cast<int>(poses.size()); }
    double time_s(int i) const { return i / options.rate_hz; }
};

/// A scene by its kind and seed: the same on every machine. No object comes closer than 0.5 m to the path
/// (movers excepted). Throws std::invalid_argument when a number is out of range.
Scene make_scene(const SceneOptions& options);
Scene make_scene(SceneKind kind, std::uint64_t seed);

/// Image i as the calibration says it was taken: the view to compare a sensor's results with.
View nominal_view(const Scene& scene, int i);

/// Everything that acts on image i: that of the camera, and the robot's heave and pitch on an uneven floor.
ImageEffects image_effects(const Scene& scene, int i);

/// Image i as it really was taken, with vibration and floor: the view of the exact flow.
View true_view(const Scene& scene, int i);

GreyImage render_image(const Scene& scene, int i);

/// Seconds since the epoch at which every scene starts.
constexpr double scene_start_s = sim::sim_start_s;

/// Image i as the sensor gets it, with the nominal camera.
Field make_field(const Scene& scene, int i);

}  // namespace flownav::testing
