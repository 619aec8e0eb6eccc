#include "config_key.h"

namespace flownav::config {
namespace {

Key label() {
    return make_key({"camera", "camera_label", "", "sensor label of the images in the rawlog"}, "any text",
                    AT(camera.camera_label), [](Config& config, const std::string& text) {
                        if (text.empty()) throw BadValue("is empty");
                        config.camera.camera_label = text;
                    });
}

std::optional<std::array<double, 5>> parse_distortion(const std::string& text) {
    if (text == "recorded") return std::nullopt;
    const auto words = words_of(text);
    std::array<double, 5> numbers{};
    if (words.size() != numbers.size()) throw BadValue("does not have 5 numbers");
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = parse_number(words[i], Range<double>{-100, 100});
    return numbers;
}

std::string format_distortion(const std::optional<std::array<double, 5>>& numbers) {
    if (!numbers) return "recorded";
    std::string text;
    for (const double number : *numbers) text += (text.empty() ? "" : " ") + format_number(number);
    return text;
}

Key distortion() {
    return make_key(
        {"camera", "distortion", "", "lens distortion k1 k2 p1 p2 k3, OpenCV's order"},
        "5 numbers, each -100 .. 100, or recorded",
        [](const Config& config) { return format_distortion(config.camera.distortion); },
        [](Config& config, const std::string& text) { config.camera.distortion = parse_distortion(text); });
}

std::vector<Key> camera_keys() {
    return {
        label(),
        word<Interlaced>(
            {"camera", "interlaced", "", "whether images are two woven fields, and which is the older"},
            {{"none", Interlaced::None},
             {"top_first", Interlaced::TopFirst},
             {"bottom_first", Interlaced::BottomFirst}},
            AT(camera.interlaced)),
        recorded_number({"camera", "height_m", "m", "height of the camera over the ground"}, {0.01, 20},
                        AT(camera.height_m)),
        recorded_number({"camera", "pitch_deg", "deg", "how far the camera looks down"}, {-5, 80},
                        AT(camera.pitch_deg)),
        recorded_number({"camera", "roll_deg", "deg", "tilt of the camera, > 0 to its right"}, {-10, 10},
                        AT(camera.roll_deg)),
        recorded_number(
            {"camera", "yaw_deg", "deg", "how far the camera looks to the left of straight ahead"}, {-10, 10},
            AT(camera.yaw_deg)),
        recorded_number({"camera", "forward_m", "m", "camera ahead of the axis the robot turns about"},
                        {-10, 10}, AT(camera.forward_m)),
        recorded_number({"camera", "left_m", "m", "camera beside that axis, > 0 to the left"}, {-10, 10},
                        AT(camera.left_m)),
        recorded_number({"camera", "fx_px", "px", "focal length across"}, {1, 50000}, AT(camera.fx_px)),
        recorded_number({"camera", "fy_px", "px", "focal length down"}, {1, 50000}, AT(camera.fy_px)),
        recorded_number({"camera", "cx_px", "px", "principal point; the middle of the first pixel is 0"},
                        {-50000, 50000}, AT(camera.cx_px)),
        recorded_number({"camera", "cy_px", "px", "principal point; of a woven image: of the whole frame"},
                        {-50000, 50000}, AT(camera.cy_px)),
        distortion(),
    };
}

std::vector<Key> flow_keys() {
    return {
        word<flow::MatcherKind>(
            {"flow", "matcher", "", "how vectors are measured: sum of absolute differences, or Lucas-Kanade"},
            {{"sad", flow::MatcherKind::Sad}, {"lk", flow::MatcherKind::Lk}}, AT(pipeline.flow.matcher)),
        number<int>({"flow", "blocks", "", "blocks placed in the image"}, {16, 2000},
                    AT(pipeline.flow.blocks)),
        word<flow::Subpixel>(
            {"flow", "subpixel", "", "refinement of a match: integer, two lines, or a parabola"},
            {{"none", flow::Subpixel::None},
             {"v", flow::Subpixel::V},
             {"parabola", flow::Subpixel::Parabola}},
            AT(pipeline.flow.subpixel)),
        word<flow::BrightnessModel>(
            {"flow", "brightness", "",
             "compensation of changing exposure: off, or gain and offset of each image"},
            {{"off", flow::BrightnessModel::Constant}, {"image", flow::BrightnessModel::Image}},
            AT(pipeline.flow.brightness)),
        number<double>({"flow", "confidence_min", "", "matches less distinct than this are left out"}, {0, 1},
                       AT(pipeline.flow.confidence_min)),
        number<double>({"flow", "blind_cone", "",
                        "no blocks nearer than this to the point the robot drives to; focal length = 1"},
                       {0, 1}, AT(pipeline.flow.focus_exclusion)),
    };
}

std::vector<Key> motion_keys() {
    return {
        word<Geometry>(
            {"motion", "geometry", "", "where vectors are evaluated: half-way, or at the reference block"},
            {{"midpoint", Geometry::MidPoint}, {"block", Geometry::Block}}, AT(pipeline.motion.geometry)),
        word<motion::MotionModel>(
            {"motion", "motion_model", "", "rotations that are estimated"},
            {{"yaw", motion::MotionModel::Yaw}, {"yaw_pitch", motion::MotionModel::YawPitch}},
            AT(pipeline.motion.model)),
        word<bool>({"motion", "pitch_online", "", "learn the camera's true pitch while driving"},
                   {{"true", true}, {"false", false}}, AT(pipeline.pitch_online)),
        number_or_word(
            {"motion", "cycle_images", "", "images compared with one reference; auto: from the speed"},
            {1, 16}, 0, "auto", AT(pipeline.rate.cycle_images)),
        number<double>({"motion", "travel_m", "m", "travel per cycle that cycle_images = auto aims at"},
                       {0.001, 10}, AT(pipeline.rate.travel_m)),
        number<double>({"motion", "gap_max_s", "s", "a longer pause between images starts afresh"},
                       {0.01, 60}, AT(pipeline.rate.gap_max_s)),
        number<double>({"motion", "carry_max_s", "s",
                        "for so long an unmeasured motion goes on as before; then the odometry stops"},
                       {0, 60}, AT(pipeline.rate.carry_max_s)),
    };
}

std::vector<Key> obstacle_keys() {
    return {
        number<double>(
            {"obstacles", "tau_px", "px", "a vector this much longer than the ground's is an obstacle"},
            {0, 20}, AT(pipeline.obstacles.tau_px)),
        number<double>(
            {"obstacles", "lambda_px", "px", "vectors farther from their line of motion are left out"},
            {0.05, 20}, AT(pipeline.obstacles.lambda_px), AT(pipeline.motion.lambda_px)),
        number<int>({"obstacles", "neighbours", "", "neighbouring blocks that must agree with an obstacle"},
                    {0, 16}, AT(pipeline.obstacles.neighbours)),
        number<double>({"obstacles", "range_max_m", "m", "points farther away are not reported"}, {0.1, 200},
                       AT(pipeline.obstacles.range_max_m)),
        number<double>({"obstacles", "height_max_m", "m", "points higher above the ground are not reported"},
                       {0.01, 20}, AT(pipeline.obstacles.height_max_m)),
        number<double>({"obstacles", "beam_deg", "deg", "width of one beam of the virtual scan"}, {0.1, 45},
                       AT(pipeline.obstacles.beam_deg)),
    };
}

std::vector<Key> map_keys() {
    return {
        number<double>({"map", "resolution_m", "m", "edge of a cell"}, {0.02, 2}, AT(map.resolution_m)),
        number<double>({"map", "size_m", "m", "edge of the local map, the robot in its middle"}, {2, 100},
                       AT(map.size_m)),
        number<double>({"map", "memory_s", "s", "the local map forgets what is older"}, {0.01, 3600},
                       AT(map.memory_s)),
    };
}

}  // namespace

const std::vector<Key>& key_table() {
    static const std::vector<Key> table = [] {
        std::vector<Key> all;
        for (const auto& keys :
             {camera_keys(), flow_keys(), motion_keys(), obstacle_keys(), map_keys(), navigation_keys()})
            all.insert(all.end(), keys.begin(), keys.end());
        return all;
    }();
    return table;
}

}  // namespace flownav::config
