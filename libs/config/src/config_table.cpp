#include "config_key.h"
#include "flownav/flow/lk_matcher.h"
#include "flownav/flow/matcher_registry.h"
#include "registered_name.h"

namespace flownav::config {
namespace {

/// Text of any kind but an empty one.
template <class Place>
Key text(const Doc& doc, Place place) {
    return make_key(
        doc, "any text", [=](const Config& config) -> std::string { return place(config); },
        [=](Config& config, const std::string& value) {
            if (value.empty()) throw BadValue("is empty");
            place(config) = value;
        });
}

/// Sets lens and coefficients from "recorded", "k1 k2 p1 p2 k3" or "LENS and 5 numbers".
void set_distortion(CameraConfig& camera, const std::string& text) {
    std::string lens = brown_conrady().name();
    std::optional<LensCoefficients> coefficients;
    if (text != "recorded") {
        auto words = words_of(text);
        if (words.size() == LensCoefficients().size() + 1) {
            lens = words.front();
            require_known(lens, lens_names());
            words.erase(words.begin());
        }
        coefficients = LensCoefficients{};
        if (words.size() != coefficients->size()) throw BadValue("does not have 5 numbers");
        for (std::size_t i = 0; i < coefficients->size(); ++i)
            (*coefficients)[i] = parse_number(words[i], Range<double>{-100, 100});
    }
    camera.lens = lens;
    camera.distortion = coefficients;
}

std::string format_distortion(const CameraConfig& camera) {
    if (!camera.distortion) return "recorded";
    std::string text = camera.lens == brown_conrady().name() ? "" : camera.lens;
    for (const double number : *camera.distortion) text += (text.empty() ? "" : " ") + format_number(number);
    return text;
}

Key distortion() {
    return make_key(
        {"camera", "distortion", "", "lens distortion k1 k2 p1 p2 k3, OpenCV's order"},
        "[lens] and 5 numbers, each -100 .. 100, or recorded; lens: " + listed(lens_names()),
        [](const Config& config) { return format_distortion(config.camera); },
        [](Config& config, const std::string& text) { set_distortion(config.camera, text); });
}

Key rotate() {
    return make_key(
        {"camera", "rotate", "",
         "degrees by which each image is turned clockwise as it is read; 180 for a camera mounted upside "
         "down"},
        "0 | 90 | 180 | 270", [](const Config& config) { return format_number(config.camera.rotate_deg); },
        [](Config& config, const std::string& text) {
            const int angle_deg = parse_number(text, Range<int>{0, 270});
            if (angle_deg % 90 != 0) throw BadValue("is none of the words");
            config.camera.rotate_deg = angle_deg;
        });
}

/// Sets the hidden rows from "none" or "FIRST LAST".
void set_mask(CameraConfig& camera, const std::string& text) {
    if (text == "none") {
        camera.masked_rows.reset();
        return;
    }
    const auto words = words_of(text);
    if (words.size() != 2) throw BadValue("is not none or two rows");
    constexpr Range<int> rows{0, 50000};
    const RowRange hidden{parse_number(words[0], rows), parse_number(words[1], rows)};
    if (hidden.first > hidden.last) throw BadValue("has its first row below the last");
    camera.masked_rows = hidden;
}

Key mask() {
    return make_key(
        {"camera", "mask", "",
         "first and last row that show the robot itself, at the bottom or top of the image; they are cut "
         "off"},
        "none, or 2 rows 0 .. 50000",
        [](const Config& config) -> std::string {
            const auto& rows = config.camera.masked_rows;
            return rows ? format_number(rows->first) + " " + format_number(rows->last) : "none";
        },
        [](Config& config, const std::string& text) { set_mask(config.camera, text); });
}

std::vector<Key> camera_keys() {
    return {
        text({"camera", "camera_label", "", "sensor label of the images in the rawlog", everyday},
             AT(camera.camera_label)),
        word<Interlaced>({"camera", "interlaced", "",
                          "whether images are two woven fields, and which is the older", everyday},
                         {{"none", Interlaced::None},
                          {"top_first", Interlaced::TopFirst},
                          {"bottom_first", Interlaced::BottomFirst}},
                         AT(camera.interlaced)),
        recorded_number({"camera", "height_m", "m", "height of the camera over the ground", everyday},
                        {0.01, 20}, AT(camera.height_m)),
        recorded_number({"camera", "pitch_deg", "deg", "how far the camera looks down", everyday}, {-5, 80},
                        AT(camera.pitch_deg)),
        recorded_number({"camera", "roll_deg", "deg", "tilt of the camera, > 0 to its right", everyday},
                        {-10, 10}, AT(camera.roll_deg)),
        recorded_number(
            {"camera", "yaw_deg", "deg", "how far the camera looks to the left of straight ahead"}, {-10, 10},
            AT(camera.yaw_deg)),
        recorded_number(
            {"camera", "forward_m", "m", "camera ahead of the axis the robot turns about", everyday},
            {-10, 10}, AT(camera.forward_m)),
        recorded_number({"camera", "left_m", "m", "camera beside that axis, > 0 to the left", everyday},
                        {-10, 10}, AT(camera.left_m)),
        recorded_number({"camera", "fx_px", "px", "focal length across"}, {1, 50000}, AT(camera.fx_px)),
        recorded_number({"camera", "fy_px", "px", "focal length down"}, {1, 50000}, AT(camera.fy_px)),
        recorded_number({"camera", "cx_px", "px", "principal point; the middle of the first pixel is 0"},
                        {-50000, 50000}, AT(camera.cx_px)),
        recorded_number({"camera", "cy_px", "px", "principal point; of a woven image: of the whole frame"},
                        {-50000, 50000}, AT(camera.cy_px)),
        distortion(),
        rotate(),
        word<bool>(
            {"camera", "mirror", "", "images show left and right exchanged; corrected as they are read"},
            {{"true", true}, {"false", false}}, AT(camera.mirror)),
        mask(),
    };
}

std::vector<Key> input_keys() {
    return {
        text({"input", "odometry_label", "", "sensor label of the wheel odometry in the rawlog"},
             AT(input.odometry_label)),
        text({"input", "truth_label", "", "sensor label of the ground truth in the rawlog"},
             AT(input.truth_label)),
        number<double>({"input", "odometry_offset_s", "s",
                        "added to the times of the odometry, when it was recorded with another clock"},
                       {-1e9, 1e9}, AT(input.odometry_offset_s)),
    };
}

std::vector<Key> flow_keys() {
    flow::register_lk_matcher();
    return {
        registered_name({"flow", "matcher", "",
                         "how vectors are measured: sum of absolute differences, or Lucas-Kanade", everyday},
                        flow::matcher_names, AT(pipeline.flow.matcher)),
        number<int>({"flow", "blocks", "", "blocks placed in the image", everyday}, {16, 2000},
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
        number<double>(
            {"flow", "focus_exclusion", "",
             "no blocks nearer than this to the point the robot drives to; focal length = 1", everyday},
            {0, 1}, AT(pipeline.flow.focus_exclusion)),
    };
}

std::vector<std::pair<const char*, pipeline::SensorUse>> sensor_uses() {
    return {{"off", pipeline::SensorUse::Off},
            {"fallback", pipeline::SensorUse::Fallback},
            {"prior", pipeline::SensorUse::Prior}};
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
        number_or_word({"motion", "cycle_images", "",
                        "images compared with one reference; auto: from the speed", everyday},
                       {1, 16}, 0, "auto", AT(pipeline.rate.cycle_images)),
        number<double>(
            {"motion", "travel_m", "m", "travel per cycle that cycle_images = auto aims at", everyday},
            {0.001, 10}, AT(pipeline.rate.travel_m)),
        word<pipeline::SensorUse>(
            {"motion", "wheels", "",
             "wheel odometry tells what the flow does not measure, or also where to look, or nothing"},
            sensor_uses(), AT(pipeline.other_sensors.wheels)),
        word<pipeline::SensorUse>({"motion", "gyro", "", "the same for the turn rate of a gyro"},
                                  sensor_uses(), AT(pipeline.other_sensors.gyro)),
        number<double>({"motion", "gap_max_s", "s", "a longer pause between images starts afresh"},
                       {0.01, 60}, AT(pipeline.rate.gap_max_s)),
        number<double>({"motion", "carry_max_s", "s",
                        "for so long an unmeasured motion goes on as before; then the odometry stops"},
                       {0, 60}, AT(pipeline.rate.carry_max_s)),
    };
}

std::vector<Key> obstacle_keys() {
    return {
        number<double>({"obstacles", "tau_px", "px",
                        "a vector this much longer than the ground's is an obstacle", everyday},
                       {0, 20}, AT(pipeline.obstacles.tau_px)),
        number<double>({"obstacles", "lambda_px", "px",
                        "vectors farther from their line of motion are left out", everyday},
                       {0.05, 20}, AT(pipeline.obstacles.lambda_px), AT(pipeline.motion.lambda_px)),
        number<int>({"obstacles", "neighbours", "", "neighbouring blocks that must agree with an obstacle"},
                    {0, 16}, AT(pipeline.obstacles.neighbours)),
        number<double>({"obstacles", "range_max_m", "m", "points farther away are not reported", everyday},
                       {0.1, 200}, AT(pipeline.obstacles.range_max_m)),
        number<double>(
            {"obstacles", "height_max_m", "m", "points higher above the ground are not reported", everyday},
            {0.01, 20}, AT(pipeline.obstacles.height_max_m)),
        number<double>({"obstacles", "beam_deg", "deg", "width of one beam of the virtual scan"}, {0.1, 45},
                       AT(pipeline.obstacles.beam_deg)),
        word<bool>({"obstacles", "contacts", "", "look for what has no texture: the contact scan"},
                   {{"true", true}, {"false", false}}, AT(pipeline.obstacles.contacts.on)),
        number<double>({"obstacles", "contact_travel_m", "m", "the robot travels so far between two scans"},
                       {0.09, 0.3}, AT(pipeline.obstacles.contacts.travel_m)),
        number<double>({"obstacles", "contact_min_m", "m", "nearer contacts are not looked for"}, {0.2, 5},
                       AT(pipeline.obstacles.contacts.range_min_m)),
        number<double>({"obstacles", "contact_max_m", "m", "contacts farther away are not reported"},
                       {0.5, 20}, AT(pipeline.obstacles.contacts.range_max_m)),
        number<double>(
            {"obstacles", "contact_votes", "", "votes of a contact that an earlier scan had as well"},
            {1, 1e5}, AT(pipeline.obstacles.contacts.score_min)),
        number<double>({"obstacles", "contact_votes_sure", "", "votes of a contact that one scan confirms"},
                       {1, 1e5}, AT(pipeline.obstacles.contacts.score_sure)),
        number<double>({"obstacles", "floor_fit_min", "",
                        "with a smaller share of the near floor that moves as a floor, a scan says nothing"},
                       {0, 1}, AT(pipeline.obstacles.contacts.fit_share_min)),
    };
}

std::vector<Key> map_keys() {
    return {
        number<double>({"map", "resolution_m", "m", "edge of a cell", everyday}, {0.02, 2},
                       AT(map.resolution_m)),
        number<double>({"map", "size_m", "m", "edge of the local map, the robot in its middle", everyday},
                       {2, 100}, AT(map.size_m)),
        number<double>({"map", "memory_s", "s", "the local map forgets what is older", everyday},
                       {0.01, 3600}, AT(map.memory_s)),
        number<double>({"map", "obstacle_below", "",
                        "local navigators: a cell less likely free than this is an obstacle"},
                       {0.05, 0.49}, AT(map.occupancy.obstacle_below)),
        number<double>({"map", "doubtful_below", "",
                        "local navigators: a cell less likely free than this may be an obstacle"},
                       {0.05, 0.49}, AT(map.occupancy.doubtful_below)),
        number<double>(
            {"map", "seen_above", "", "local navigators: ground more likely free than this was seen"},
            {0.51, 0.95}, AT(map.occupancy.seen_above)),
        number<double>(
            {"map", "guard_obstacle_below", "", "guard: a cell less likely free than this is an obstacle"},
            {0.05, 0.49}, AT(map.occupancy.guard_obstacle_below)),
        number<double>(
            {"map", "guard_free_above", "", "guard: ground more likely free than this was seen to be free"},
            {0.51, 0.95}, AT(map.occupancy.guard_free_above)),
        number<double>(
            {"map", "plan_obstacle_below", "", "planner: a cell less likely free than this is an obstacle"},
            {0.05, 0.49}, AT(map.occupancy.plan_obstacle_below)),
        number<double>({"map", "plan_certain_below", "",
                        "planner without another way, or with a dear one only: such a cell is an obstacle"},
                       {0.05, 0.49}, AT(map.occupancy.plan_certain_below)),
        number<double>({"map", "backing_free_above", "", "ground at least so likely free may be backed over"},
                       {0.51, 0.95}, AT(map.occupancy.backing_free_above)),
        number<double>(
            {"map", "export_occupied_below", "", "map.pgm: a cell less likely free than this is occupied"},
            {0.05, 0.49}, AT(map.occupancy.export_occupied_below)),
        number<double>({"map", "export_free_above", "", "map.pgm: a cell more likely free than this is free"},
                       {0.51, 0.95}, AT(map.occupancy.export_free_above)),
    };
}

}  // namespace

const std::vector<Key>& key_table() {
    static const std::vector<Key> table = [] {
        std::vector<Key> all;
        for (const auto& keys : {camera_keys(), input_keys(), flow_keys(), motion_keys(), obstacle_keys(),
                                 map_keys(), navigation_keys(), guard_keys()})
            all.insert(all.end(), keys.begin(), keys.end());
        return all;
    }();
    return table;
}

}  // namespace flownav::config
