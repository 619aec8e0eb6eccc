#include <mrpt/3rdparty/tclap/CmdLine.h>

#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "flownav/testing/write_scene.h"

namespace {

using namespace flownav::testing;

constexpr int exit_usage = 1;
constexpr int exit_output = 3;

struct Request {
    SceneOptions scene;
    WriteOptions write;
    std::string output;
    bool list = false;
};

std::string kinds() {
    std::string names;
    for (const SceneKind kind : all_scene_kinds)
        names += (names.empty() ? "" : ", ") + std::string(to_string(kind));
    return names;
}

SceneKind kind_of(const std::string& name) {
    const auto kind = scene_kind(name);
    if (!kind) throw std::invalid_argument("KIND '" + name + "' is unknown: choose one of " + kinds());
    return *kind;
}

Request parse(int argc, char** argv) {
    TCLAP::CmdLine cmd(
        "Renders a synthetic drive with exact truth: BASENAME.rawlog, BASENAME.gt.csv, BASENAME.objects.csv. "
        "Exit status: 0 fine, 1 bad usage, 3 the output cannot be written.",
        ' ', "1");
    std::vector<std::string> floors{"carpet", "tiles", "lino", "plain"};
    TCLAP::ValuesConstraint<std::string> floor_names(floors);
    TCLAP::SwitchArg list("l", "list", "print the kinds of scenes and stop", cmd);
    TCLAP::SwitchArg interlaced("", "interlaced", "fields of alternating parity instead of frames", cmd);
    TCLAP::ValueArg<int> gz("", "gz", "gz level of the rawlog, 0 to 9", false, 6, "N", cmd);
    TCLAP::ValueArg<int> height("", "height", "of a frame, px", false, 480, "PX", cmd);
    TCLAP::ValueArg<int> width("", "width", "of a frame, px", false, 640, "PX", cmd);
    TCLAP::ValueArg<double> rate("", "rate", "images per second", false, 25.0, "HZ", cmd);
    TCLAP::ValueArg<double> speed("", "speed", "of the robot, m/s", false, 0.4, "MPS", cmd);
    TCLAP::ValueArg<double> vibration("", "vibration", "of the pitch, standard deviation in degrees", false,
                                      0.0, "DEG", cmd);
    TCLAP::ValueArg<double> exposure("", "exposure",
                                     "change of the gain from image to image, standard deviation", false, 0.0,
                                     "SHARE", cmd);
    TCLAP::ValueArg<double> noise("", "noise", "standard deviation of the pixel noise, grey levels", false,
                                  2.5, "S", cmd);
    TCLAP::ValueArg<std::string> floor("", "floor", "carpet, tiles, lino or plain", false, "carpet",
                                       &floor_names, cmd);
    TCLAP::ValueArg<int> images("", "images", "number of images", false, 120, "M", cmd);
    TCLAP::ValueArg<std::uint64_t> seed("", "seed", "same seed, same bytes", false, 1, "N", cmd);
    TCLAP::ValueArg<std::string> output("o", "output", "where to write, without suffix", false, "",
                                        "BASENAME", cmd);
    TCLAP::UnlabeledValueArg<std::string> kind("kind", "kind of scene: " + kinds(), false, "s-curve", "KIND",
                                               cmd);
    cmd.parse(argc, argv);

    Request request;
    request.list = list.getValue();
    request.output = output.getValue();
    if (request.list) return request;
    if (request.output.empty()) throw std::invalid_argument("--output BASENAME is missing");
    SceneOptions& scene = request.scene;
    scene.kind = kind_of(kind.getValue());
    scene.seed = seed.getValue();
    scene.images = images.getValue();
    scene.rate_hz = rate.getValue();
    scene.speed_mps = speed.getValue();
    scene.floor = *floor_surface(floor.getValue());
    scene.camera = standard_camera(width.getValue(), height.getValue());
    scene.interlaced = interlaced.getValue();
    scene.effects.noise_sigma = noise.getValue();
    scene.effects.gain_sigma = exposure.getValue();
    scene.effects.pitch_vibration_rad = vibration.getValue() * M_PI / 180.0;
    request.write.gz_level = gz.getValue();
    return request;
}

int run(const Request& request) {
    if (request.list) {
        for (const SceneKind kind : all_scene_kinds) std::cout << to_string(kind) << '\n';
        return 0;
    }
    const Scene scene = make_scene(request.scene);
    try {
        write_scene(scene, request.output, request.write);
    } catch (const std::exception& e) {
        std::cerr << "flownav-make-scene: " << e.what() << '\n';
        return exit_output;
    }
    std::cout << request.output << ".rawlog: " << scene.images() << " images\n";
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(parse(argc, argv));
    } catch (const std::exception& e) {
        std::cerr << "flownav-make-scene: " << e.what() << '\n';
        return exit_usage;
    }
}
