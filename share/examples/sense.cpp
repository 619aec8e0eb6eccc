// Image stream -> obstacles: sense INPUT.rawlog [CONFIG.ini] prints the obstacle points of a rawlog, one a
// line: time stamp, and x (forward), y (left), z (up) in metres in the robot frame at that time.
#include <flownav/config/make_state.h>
#include <flownav/io/field_source.h>

#include <cstdio>

int main(int argc, char** argv) try {
    if (argc < 2) throw std::invalid_argument("usage: sense INPUT.rawlog [CONFIG.ini]");
    flownav::config::Config config;
    if (argc > 2) flownav::config::load_config_file(config, argv[2]);
    flownav::io::RawlogReader reader(argv[1]);
    flownav::io::FieldSource source(reader, config.camera);
    flownav::pipeline::State state = flownav::config::make_state(config);
    while (const auto event = source.next()) {
        const auto* field = std::get_if<flownav::Field>(&*event);
        if (field == nullptr) continue;  // a pose
        const flownav::pipeline::Step& step = flownav::pipeline::step(state, *field);
        for (const flownav::ObstaclePoint& point : step.obstacles) {
            const Eigen::Vector3d& p = point.position_m;
            std::printf("%.3f %.2f %.2f %.2f\n", step.timestamp_s, p.x(), p.y(), p.z());
        }
    }
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
