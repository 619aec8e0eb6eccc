#include "drives.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "flownav/math/units.h"

namespace flownav::testing {

Scene drive(const DriveOptions& options) {
    SceneOptions scene_options;
    scene_options.kind = options.kind;
    scene_options.seed = 4;
    scene_options.images = options.images;
    scene_options.rate_hz = options.rate_hz;
    scene_options.interlaced = options.interlaced;
    scene_options.floor = options.floor;
    scene_options.camera = options.camera;
    Scene scene = make_scene(scene_options);
    const double image_s = 1.0 / scene_options.rate_hz;
    const Pose2 step = along_arc(options.omega_degps * degree_rad * image_s, options.v_mps * image_s);
    for (std::size_t i = 1; i < scene.poses.size(); ++i) scene.poses[i] = compose(scene.poses[i - 1], step);
    return scene;
}

std::vector<Field> render_fields(const Scene& scene) {
    std::vector<Field> fields;
    fields.reserve(static_cast<std::size_t>(scene.images()));
    for (int i = 0; i < scene.images(); ++i) fields.push_back(make_field(scene, i));
    return fields;
}

std::vector<pipeline::Step> run(const std::vector<Field>& fields, const pipeline::Params& params) {
    pipeline::State state(params);
    std::vector<pipeline::Step> steps;
    steps.reserve(fields.size());
    for (const Field& field : fields) steps.push_back(pipeline::step(state, field));
    return steps;
}

pipeline::Params cycles_of(int images) {
    pipeline::Params params;
    params.rate.cycle_images = images;
    return params;
}

Field grey_field(const Field& like, std::uint8_t grey, double later_s) {
    auto image = std::make_shared<GreyImage>(like.image.width_px, like.image.height_px);
    std::fill(image->pixels.begin(), image->pixels.end(), grey);
    return {like.timestamp_s + later_s, image->view(), like.camera, image};
}

Field delayed(Field field, double later_s) {
    field.timestamp_s += later_s;
    return field;
}

std::string fingerprint(const pipeline::Step& step) {
    std::ostringstream out;
    out << std::hexfloat << step.timestamp_s << ' ' << to_string(step.status) << ' ' << step.image_of_cycle
        << ' ' << step.cycle_images << ' ' << step.end_of_cycle << ' ' << step.omega_radps << ' '
        << step.pitch_rate_radps << ' ' << step.v_mps << ' ' << step.v_measured << ' '
        << step.T_start_robot.x_m << ' ' << step.T_start_robot.y_m << ' ' << step.T_start_robot.yaw_rad
        << '\n';
    for (const pipeline::BlockRecord& b : step.blocks) {
        out << b.vector.at_px.transpose() << ' ' << b.vector.flow_px.transpose() << ' ' << b.excess_px << ' '
            << to_string(b.label) << '\n';
    }
    for (const ObstaclePoint& p : step.obstacles)
        out << p.position_m.transpose() << ' ' << p.sigma_m << ' ' << p.at_px.transpose() << '\n';
    for (const GroundPatch& p : step.ground)
        out << p.near_m.transpose() << ' ' << p.far_m.transpose() << '\n';
    for (const Beam& b : step.scan.beams) out << static_cast<int>(b.kind) << ' ' << b.range_m << '\n';
    return out.str();
}

}  // namespace flownav::testing
