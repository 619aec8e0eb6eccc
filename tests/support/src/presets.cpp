#include "flownav/testing/presets.h"

#include <algorithm>
#include <cmath>

#include "flownav/math/units.h"

namespace flownav::testing {
namespace {

void no_change(SceneOptions& /*options*/) {}

/// 90 degrees wide from edge to edge; k2 keeps the lens invertible out to the corners.
CameraModel wide_camera() {
    CameraModel camera = standard_camera();
    camera.distortion = {-0.3, 0.1, 0.0, 0.0, 0.0};
    const double edge = 1.0 + camera.distortion[0] + camera.distortion[1];
    camera.fx_px = camera.fy_px = 0.5 * camera.width_px / edge;
    return camera;
}

void with_mover(SceneOptions& options, const MoverOptions& mover) {
    options.kind = SceneKind::Mover;
    options.mover = mover;
    options.images = 240;
}

std::vector<Preset> floors() {
    return {
        {"carpet", "rich texture", no_change},
        {"tiles", "stoneware tiles: joints, faint specks inside",
         [](SceneOptions& o) { o.floor = Surface::Stoneware; }},
        {"lino", "marbled linoleum: faint flecks and streaks",
         [](SceneOptions& o) { o.floor = Surface::Marbled; }},
        {"plain", "a floor without any texture", [](SceneOptions& o) { o.floor = Surface::Plain; }},
        {"uneven", "bumps of the floor up to 12 mm up and down, the robot rides on them",
         [](SceneOptions& o) { o.floor_waves_m = 0.012; }},
    };
}

std::vector<Preset> drives() {
    return {
        {"turns", "turns of 30 deg/s between straight pieces",
         [](SceneOptions& o) { o.kind = SceneKind::Turns, o.turn_radps = 30.0 * degree_rad; }},
        {"vibration015", "pitch vibration, 0.15 deg rms from image to image",
         [](SceneOptions& o) { o.effects.pitch_vibration_rad = 0.15 * degree_rad; }},
        {"vibration03", "pitch vibration, 0.3 deg rms from image to image",
         [](SceneOptions& o) { o.effects.pitch_vibration_rad = 0.3 * degree_rad; }},
        {"mover25", "a trolley 1.5 m wide crosses ahead at 0.25 m/s",
         [](SceneOptions& o) {
             with_mover(o, {0.25, 1.5, 1.6, 1.95});
         }},
        {"mover45", "a trolley 2.3 m wide crosses ahead at 0.45 m/s",
         [](SceneOptions& o) {
             with_mover(o, {0.45, 2.3, 2.9, 2.4});
         }},
        {"near-obstacle", "boxes inside the ground window, 0.28 m beside the path",
         [](SceneOptions& o) { o.near_boxes = true, o.turn_radps = 6.0 * degree_rad; }},
    };
}

std::vector<Preset> cameras() {
    return {
        {"pal", "interlaced fields of 768x288 with alternating parity",
         [](SceneOptions& o) { o.camera = standard_camera(768, 576), o.interlaced = true; }},
        {"ahead", "camera 0.2 m ahead of the axis, turns of 30 deg/s",
         [](SceneOptions& o) {
             o.kind = SceneKind::Turns;
             o.turn_radps = 30.0 * degree_rad;
             o.camera.mount.forward_m = 0.2;
         }},
        {"roll", "camera tilted by 2 deg",
         [](SceneOptions& o) { o.camera.mount.roll_rad = 2.0 * degree_rad; }},
        {"wide", "lens of 90 deg with k1 = -0.3, k2 = 0.1",
         [](SceneOptions& o) { o.camera = wide_camera(); }},
    };
}

std::vector<Preset> pictures() {
    return {
        {"blur", "shutter open for half of the time between images",
         [](SceneOptions& o) { o.effects.exposure_s = 0.5 / o.rate_hz; }},
        {"noise5", "pixel noise of 5 grey levels", [](SceneOptions& o) { o.effects.noise_sigma = 5.0; }},
        {"noise10", "pixel noise of 10 grey levels", [](SceneOptions& o) { o.effects.noise_sigma = 10.0; }},
        {"exposure-steps", "auto exposure steps by 10 % every 0.5 to 1 s",
         [](SceneOptions& o) { o.effects.exposure_step = 0.1; }},
        {"flicker", "lamps flicker by 5 %: a fast sine, and 1 % at random",
         [](SceneOptions& o) { o.effects.flicker = 0.05, o.effects.gain_sigma = 0.01; }},
    };
}

}  // namespace

SceneOptions common_preset(std::uint64_t seed) {
    SceneOptions options;
    options.kind = SceneKind::SCurve;
    options.seed = seed;
    options.images = 200;
    options.turn_radps = 20.0 * degree_rad;
    options.rails = true;
    return options;
}

const std::vector<Preset>& all_presets() {
    static const std::vector<Preset> presets = [] {
        std::vector<Preset> all;
        for (const auto& group : {floors(), drives(), cameras(), pictures()})
            all.insert(all.end(), group.begin(), group.end());
        return all;
    }();
    return presets;
}

std::optional<SceneOptions> preset(const std::string& name, std::uint64_t seed) {
    const auto& presets = all_presets();
    const auto found =
        std::find_if(presets.begin(), presets.end(), [&](const Preset& p) { return p.name == name; });
    if (found == presets.end()) return std::nullopt;
    SceneOptions options = common_preset(seed);
    found->apply(options);
    return options;
}

}  // namespace flownav::testing
