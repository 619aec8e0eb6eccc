#include "flownav/testing/scene.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "flownav/sim/random.h"
#include "flownav/sim/world_look.h"
#include "layout.h"
#include "path.h"
#include "ride.h"

namespace flownav::testing {
namespace {

void check(const SceneOptions& options) {
    if (options.images < 2 || options.images > 100000)
        throw std::invalid_argument("images = " + std::to_string(options.images) + ": choose 2 to 100000");
    if (!(options.rate_hz > 0.0 && options.rate_hz <= 1000.0)) {
        throw std::invalid_argument("rate_hz = " + std::to_string(options.rate_hz) +
                                    ": choose above 0, up to 1000");
    }
    if (options.camera.width_px < 16 || options.camera.height_px < 16 || options.camera.width_px > 8192 ||
        options.camera.height_px > 8192) {
        throw std::invalid_argument("image of " + std::to_string(options.camera.width_px) + " x " +
                                    std::to_string(options.camera.height_px) + " px: choose 16 to 8192");
    }
    if (options.effects.grey_step < 1 || options.effects.grey_step > 64) {
        throw std::invalid_argument("grey_step = " + std::to_string(options.effects.grey_step) +
                                    ": choose 1 to 64");
    }
    if (!(options.turn_radps >= 0.0 && options.turn_radps <= 6.3)) {
        throw std::invalid_argument("turn_radps = " + std::to_string(options.turn_radps) +
                                    ": choose 0 to 6.3");
    }
    if (!(options.effects.exposure_s >= 0.0 && options.effects.exposure_s * options.rate_hz <= 1.0)) {
        throw std::invalid_argument("exposure_s = " + std::to_string(options.effects.exposure_s) +
                                    ": choose 0 up to the time between images");
    }
    if (!(options.speed_mps >= 0.0 && options.speed_mps <= 10.0))
        throw std::invalid_argument("speed_mps = " + std::to_string(options.speed_mps) + ": choose 0 to 10");
    if (!(options.floor_waves_m >= 0.0 && options.floor_waves_m <= 0.03)) {
        throw std::invalid_argument("floor_waves_m = " + std::to_string(options.floor_waves_m) +
                                    ": choose 0 to 0.03");
    }
}

/// Motion of the robot from image i to the next, or to image i from the one before at the end of the drive.
EgoMotion motion_at(const Scene& scene, int i) {
    const auto first = static_cast<std::size_t>(std::min(i, scene.images() - 2));
    return exact_motion(scene.poses[first], scene.poses[first + 1]);
}

/// Where the camera is while the shutter is open.
std::vector<View> views_during_exposure(const Scene& scene, int i) {
    const View middle = nominal_view(scene, i);
    const double exposure_s = scene.options.effects.exposure_s;
    if (exposure_s <= 0.0) return {middle};
    constexpr int moments = 8;
    const EgoMotion motion = motion_at(scene, i);
    std::vector<View> views(moments, middle);
    for (int k = 0; k < moments; ++k) {
        const double later_s = exposure_s * ((k + 0.5) / moments - 0.5);
        const double share = later_s * scene.options.rate_hz;
        View& view = views[static_cast<std::size_t>(k)];
        view.time_s += later_s;
        view.T_world_robot =
            compose(view.T_world_robot, along_arc(share * motion.omega_rad, share * motion.forward_m));
    }
    return views;
}

}  // namespace

const char* to_string(SceneKind kind) {
    switch (kind) {
        case SceneKind::Free:
            return "free";
        case SceneKind::Straight:
            return "straight";
        case SceneKind::SCurve:
            return "s-curve";
        case SceneKind::Turns:
            return "turns";
        case SceneKind::Corridor:
            return "corridor";
        case SceneKind::StopAndGo:
            return "stop-and-go";
        case SceneKind::Mover:
            return "mover";
        case SceneKind::Loop:
            return "loop";
    }
    return "";
}

std::optional<Surface> floor_surface(const std::string& name) {
    for (const auto& [word, surface] : sim::floor_surfaces())
        if (word == name) return surface;
    return std::nullopt;
}

std::optional<SceneKind> scene_kind(const std::string& name) {
    for (const SceneKind kind : all_scene_kinds)
        if (name == to_string(kind)) return kind;
    return std::nullopt;
}

Scene make_scene(const SceneOptions& options) {
    check(options);
    Scene scene;
    scene.options = options;
    scene.options.effects.seed = sim::mix(options.seed, 11);
    scene.poses = make_path(options);
    scene.world = make_world(options, scene.poses);
    return scene;
}

Scene make_scene(SceneKind kind, std::uint64_t seed) {
    SceneOptions options;
    options.kind = kind;
    options.seed = seed;
    return make_scene(options);
}

View nominal_view(const Scene& scene, int i) {
    const SceneOptions& o = scene.options;
    const Parity parity = i % 2 == 0 ? Parity::Top : Parity::Bottom;
    const CameraModel camera = o.interlaced ? field_camera(o.camera, parity) : o.camera;
    return {camera, scene.poses.at(static_cast<std::size_t>(i)), scene.time_s(i)};
}

ImageEffects image_effects(const Scene& scene, int i) {
    ImageEffects effects = effects_of_image(scene.options.effects, i);
    if (scene.world.waves.highest_m == 0.0) return effects;
    const Ride ride = ride_over(scene.world, scene.poses.at(static_cast<std::size_t>(i)));
    effects.height_m += ride.heave_m;
    effects.pitch_rad += ride.pitch_rad;
    return effects;
}

View true_view(const Scene& scene, int i) {
    View view = nominal_view(scene, i);
    view.camera = with_effects(view.camera, image_effects(scene, i));
    return view;
}

GreyImage render_image(const Scene& scene, int i) {
    return render(scene.world, views_during_exposure(scene, i), image_effects(scene, i));
}

Field make_field(const Scene& scene, int i) {
    const auto image = std::make_shared<GreyImage>(render_image(scene, i));
    return {scene_start_s + scene.time_s(i), image->view(), nominal_view(scene, i).camera, image};
}

}  // namespace flownav::testing
