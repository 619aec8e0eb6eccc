#include "told_drives.h"

namespace flownav::testing {
namespace {

/// Poses as the wheels count them.
std::vector<Pose2> counted(const std::vector<Pose2>& poses, const RobotSensors& sensors) {
    std::vector<Pose2> wheels = {{5.0, -2.0, 1.0}};
    for (std::size_t i = 1; i < poses.size(); ++i) {
        const Pose2 moved = compose(inverse(poses[i - 1]), poses[i]);
        const double way_m = std::copysign(std::hypot(moved.x_m, moved.y_m), moved.x_m);
        const Pose2 told = along_arc(sensors.turn_scale * moved.yaw_rad, sensors.way_scale * way_m);
        wheels.push_back(compose(wheels.back(), told));
    }
    return wheels;
}

}  // namespace

Field without_texture(const Field& like, unsigned seed) {
    const auto image = std::make_shared<GreyImage>(like.image.width_px, like.image.height_px);
    std::uint32_t state = 77U * seed + 1U;
    for (std::uint8_t& pixel : image->pixels) {
        state = state * 1664525U + 1013904223U;
        pixel = static_cast<std::uint8_t>(120U + (state >> 29U));
    }
    Field field = like;
    field.image = image->view();
    field.owner = image;
    return field;
}

std::vector<pipeline::Step> run(pipeline::State& state, const std::vector<Field>& fields,
                                const std::vector<Pose2>& poses, const RobotSensors& sensors) {
    const std::vector<Pose2> wheels = counted(poses, sensors);
    const auto note = [&](std::size_t i) {
        const double time_s = fields[i].timestamp_s + sensors.clock_s;
        if (sensors.wheels && i >= sensors.wheels_first) pipeline::note_wheels(state, {time_s, wheels[i]});
        if (!sensors.gyro || i == 0) return;
        const double dt_s = fields[i].timestamp_s - fields[i - 1].timestamp_s;
        const double omega_radps = wrap_angle(poses[i].yaw_rad - poses[i - 1].yaw_rad) / dt_s;
        pipeline::note_gyro(state,
                            {time_s - dt_s / 2, sensors.turn_scale * omega_radps + sensors.gyro_bias_radps});
    };
    std::vector<pipeline::Step> steps;
    note(0);
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (i + 1 < fields.size()) note(i + 1);
        steps.push_back(pipeline::step(state, fields[i]));
    }
    return steps;
}

std::vector<pipeline::Step> run(const std::vector<Field>& fields, const std::vector<Pose2>& poses,
                                const RobotSensors& sensors, const pipeline::Params& params) {
    pipeline::State state(params);
    return run(state, fields, poses, sensors);
}

}  // namespace flownav::testing
