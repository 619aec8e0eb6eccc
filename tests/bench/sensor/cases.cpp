#include "cases.h"

#include <cmath>

#include "flownav/math/units.h"

namespace flownav::sensor_bench {
namespace {

std::string number(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

template <class Value, class Change>
std::vector<Case> vary(const std::vector<Value>& values, const std::string& unit, Change change) {
    std::vector<Case> cases;
    for (const Value& value : values) {
        Case one;
        one.name = number(value) + unit;
        change(one, value);
        cases.push_back(one);
    }
    return cases;
}

Case with_camera(const std::string& name, const Candidate& camera) {
    return {name, camera, {}, {}};
}

std::vector<Case> pictures() {
    return {with_camera("640x480, 25 Hz", {}),
            with_camera("640x480, 50 Hz", {640, 480, false, 50.0}),
            with_camera("640x360, 30 Hz", {640, 360, false, 30.0}),
            with_camera("768x288 PAL fields, 50 Hz", {768, 288, true, 50.0}),
            with_camera("768x288 PAL fields, 50 Hz, 55 deg", {768, 288, true, 50.0, 55.0}),
            with_camera("320x240, 25 Hz", {320, 240, false, 25.0})};
}

std::vector<Case> mounts() {
    std::vector<Case> cases;
    for (const auto& [height_m, pitch_deg] : {std::pair(0.4, 10.0),
                                              {0.4, 18.0},
                                              {0.6, 10.0},
                                              {0.6, 18.0},
                                              {0.6, 25.0},
                                              {0.8, 18.0},
                                              {0.8, 25.0}}) {
        Case one;
        one.name = number(height_m) + " m, " + number(pitch_deg) + " deg down";
        one.camera.height_m = height_m;
        one.camera.pitch_deg = pitch_deg;
        cases.push_back(one);
    }
    return cases;
}

std::vector<Case> turns() {
    std::vector<Case> cases;
    for (const double wide_deg : {90.0, 55.0}) {
        for (const double turn : {0.0, 0.3, 0.6, 1.0, 1.5}) {
            Case one;
            one.name = number(turn) + " rad/s, " + number(wide_deg) + " deg wide";
            one.camera.wide_deg = wide_deg;
            one.drive.turn_radps = turn;
            cases.push_back(one);
        }
    }
    return cases;
}

std::vector<Case> looks() {
    std::vector<Case> cases;
    for (const PostLook look : {PostLook::Textured, PostLook::LowTexture, PostLook::Silhouette}) {
        for (const auto& [floor, name] : {std::pair(sim::Surface::Carpet, "carpet"),
                                          {sim::Surface::Tiles, "tiles"},
                                          {sim::Surface::Lino, "lino"}}) {
            Case one;
            one.name = std::string(to_string(look)) + " on " + name;
            one.drive.look = look;
            one.drive.floor = floor;
            cases.push_back(one);
        }
    }
    return cases;
}

std::vector<Case> settings() {
    const std::vector<Settings> all = {{},
                                       {{"motion.travel_m", "0.08"}, {"flow.focus_exclusion", "0.25"}},
                                       {{"motion.travel_m", "0.08"}},
                                       {{"motion.travel_m", "0.12"}},
                                       {{"motion.travel_m", "0.2"}},
                                       {{"flow.focus_exclusion", "0.25"}},
                                       {{"flow.focus_exclusion", "0.06"}},
                                       {{"obstacles.neighbours", "1"}},
                                       {{"obstacles.neighbours", "3"}},
                                       {{"obstacles.tau_px", "2"}},
                                       {{"flow.confidence_min", "0.12"}},
                                       {{"flow.blocks", "600"}},
                                       {{"flow.blocks", "600"}, {"obstacles.neighbours", "3"}}};
    std::vector<Case> cases;
    for (const Settings& settings : all) {
        Case one;
        for (const auto& [key, value] : settings)
            one.name += (one.name.empty() ? "" : ", ") + key + " = " + value;
        if (settings.empty()) one.name = "as recommended";
        one.settings = settings;
        cases.push_back(one);
    }
    return cases;
}

}  // namespace

std::vector<Section> all_sections() {
    return {{"lens", "Width of the lens",
             vary<double>({55, 70, 90, 110}, " deg", [](Case& c, double v) { c.camera.wide_deg = v; })},
            {"pictures", "Pictures", pictures()},
            {"mount", "Height and pitch", mounts()},
            {"speed", "Speed",
             vary<double>({0.4, 0.8, 1.2}, " m/s", [](Case& c, double v) { c.drive.speed_mps = v; })},
            {"turn", "Turn rate", turns()},
            {"look", "Posts and floor", looks()},
            {"settings", "Settings", settings()}};
}

Settings recommended_settings() {
    return {{"motion.travel_m", "0.16"}, {"flow.focus_exclusion", "0.12"}};
}

sim::CameraSimParams to_simulator(const Candidate& candidate) {
    sim::CameraSimParams params;
    CameraModel& camera = params.camera;
    camera.width_px = candidate.width_px;
    camera.height_px = candidate.interlaced ? 2 * candidate.height_px : candidate.height_px;
    camera.fx_px = camera.fy_px = candidate.width_px / 2.0 / std::tan(candidate.wide_deg / 2 * degree_rad);
    camera.cx_px = (camera.width_px - 1) / 2.0;
    camera.cy_px = (camera.height_px - 1) / 2.0;
    camera.mount.height_m = candidate.height_m;
    camera.mount.pitch_rad = candidate.pitch_deg * degree_rad;
    params.interlaced = candidate.interlaced;
    params.rate_hz = candidate.rate_hz;
    params.effects.noise_sigma = 2.0;
    params.effects.blur_px = 0.5;
    params.effects.vignetting = 0.2;
    params.effects.pitch_vibration_deg = 0.05;
    params.effects.roll_vibration_deg = 0.05;
    return params;
}

}  // namespace flownav::sensor_bench
