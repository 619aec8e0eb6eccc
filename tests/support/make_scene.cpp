#include <mrpt/3rdparty/tclap/CmdLine.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "flownav/math/units.h"
#include "flownav/testing/presets.h"
#include "flownav/testing/write_scene.h"

namespace {

using namespace flownav::testing;

constexpr int exit_usage = 1;
constexpr int exit_output = 3;

std::string kinds() {
    std::string names;
    for (const SceneKind kind : all_scene_kinds)
        names += (names.empty() ? "" : ", ") + std::string(to_string(kind));
    return names;
}

/// Bad arguments become an exception like every other error.
class Output : public TCLAP::StdOutput {
  public:
    void failure(TCLAP::CmdLineInterface& /*cmd*/, TCLAP::ArgException& e) override {
        throw std::invalid_argument(e.error() + ' ' + e.argId() + "\nTry flownav-make-scene --help");
    }
};

struct Arguments {
    Output output_style;
    std::vector<std::string> floors{"carpet", "tiles", "lino", "plain", "stoneware", "marbled"};
    TCLAP::ValuesConstraint<std::string> floor_names{floors};
    TCLAP::CmdLine cmd{
        "Renders a synthetic drive with exact truth: BASENAME.rawlog, BASENAME.gt.csv, BASENAME.objects.csv. "
        "Exit status: 0 fine, 1 bad usage, 3 the output cannot be written.",
        ' ', "1"};
    TCLAP::SwitchArg list{"l", "list", "print the kinds of scenes and the presets and stop", cmd};
    TCLAP::ValueArg<std::string> preset{
        "p",   "preset", "a named scene instead of KIND; of the other options only --seed and --images count",
        false, "",       "NAME",
        cmd};
    TCLAP::ValueArg<int> gz{"", "gz", "gz level of the rawlog, 0 to 9", false, 6, "N", cmd};
    TCLAP::ValueArg<int> grey_step{
        "", "grey-step", "greys are multiples of this: pictures pack better", false, 1, "N", cmd};
    TCLAP::SwitchArg interlaced{"", "interlaced", "fields of alternating parity instead of frames", cmd};
    TCLAP::ValueArg<int> height{"", "height", "of a frame, px", false, 480, "PX", cmd};
    TCLAP::ValueArg<int> width{"", "width", "of a frame, px", false, 640, "PX", cmd};
    TCLAP::ValueArg<double> rate{"", "rate", "images per second", false, 25.0, "HZ", cmd};
    TCLAP::ValueArg<double> speed{"", "speed", "of the robot, m/s", false, 0.4, "MPS", cmd};
    TCLAP::ValueArg<double> turn{
        "", "turn", "fastest turn of s-curve and turns, degrees per second", false, 30.0, "DEGPS", cmd};
    TCLAP::ValueArg<double> blur{
        "", "blur", "time that the shutter stays open, seconds: motion blur", false, 0.0, "S", cmd};
    TCLAP::ValueArg<double> vibration{
        "", "vibration", "of the pitch, standard deviation in degrees", false, 0.0, "DEG", cmd};
    TCLAP::ValueArg<double> exposure{
        "", "exposure", "standard deviation of the gain from image to image", false, 0.0, "SHARE", cmd};
    TCLAP::ValueArg<double> exposure_step{"",
                                          "exposure-step",
                                          "by which auto exposure steps up or down every 12 to 24 images",
                                          false,
                                          0.0,
                                          "SHARE",
                                          cmd};
    TCLAP::ValueArg<double> flicker{
        "", "flicker", "amplitude of the lamps' brightness, a fast sine", false, 0.0, "SHARE", cmd};
    TCLAP::ValueArg<double> noise{
        "", "noise", "standard deviation of the pixel noise, grey levels", false, 2.5, "S", cmd};
    TCLAP::ValueArg<std::string> floor{"",           "floor", "what the floor looks like", false, "carpet",
                                       &floor_names, cmd};
    TCLAP::ValueArg<int> images{"", "images", "number of images", false, 120, "M", cmd};
    TCLAP::ValueArg<std::uint64_t> seed{"", "seed", "same seed, same bytes", false, 1, "N", cmd};
    TCLAP::ValueArg<std::string> output{"o",        "output", "where to write, without suffix", false, "",
                                        "BASENAME", cmd};
    TCLAP::UnlabeledValueArg<std::string> kind{"kind", "kind of scene: " + kinds(), false, "s-curve", "KIND",
                                               cmd};
};

SceneOptions preset_options(Arguments& arguments) {
    const std::string& name = arguments.preset.getValue();
    auto scene = preset(name, arguments.seed.getValue());
    if (!scene) throw std::invalid_argument("--preset '" + name + "' is unknown: --list prints them");
    if (arguments.images.isSet()) scene->images = arguments.images.getValue();
    return *scene;
}

SceneOptions scene_options(Arguments& arguments) {
    if (arguments.preset.isSet()) return preset_options(arguments);
    const std::string& name = arguments.kind.getValue();
    const auto kind = scene_kind(name);
    if (!kind) throw std::invalid_argument("KIND '" + name + "' is unknown: choose one of " + kinds());
    SceneOptions scene;
    scene.kind = *kind;
    scene.seed = arguments.seed.getValue();
    scene.images = arguments.images.getValue();
    scene.rate_hz = arguments.rate.getValue();
    scene.speed_mps = arguments.speed.getValue();
    scene.turn_radps = arguments.turn.getValue() * flownav::degree_rad;
    scene.effects.exposure_s = arguments.blur.getValue();
    scene.floor = floor_surface(arguments.floor.getValue()).value();
    scene.camera = standard_camera(arguments.width.getValue(), arguments.height.getValue());
    scene.interlaced = arguments.interlaced.getValue();
    scene.effects.noise_sigma = arguments.noise.getValue();
    scene.effects.grey_step = arguments.grey_step.getValue();
    scene.effects.gain_sigma = arguments.exposure.getValue();
    scene.effects.exposure_step = arguments.exposure_step.getValue();
    scene.effects.flicker = arguments.flicker.getValue();
    scene.effects.pitch_vibration_rad = arguments.vibration.getValue() * flownav::degree_rad;
    return scene;
}

void print_list() {
    for (const SceneKind kind : all_scene_kinds) std::cout << to_string(kind) << '\n';
    std::cout << "\npresets:\n";
    for (const Preset& p : all_presets())
        std::cout << std::left << std::setw(16) << p.name << p.meaning << '\n';
}

int write(const Scene& scene, const std::string& basename, int gz_level) {
    WriteOptions options;
    options.gz_level = gz_level;
    try {
        write_scene(scene, basename, options);
    } catch (const std::exception& e) {
        std::cerr << "flownav-make-scene: " << e.what() << '\n';
        return exit_output;
    }
    std::cout << basename << ".rawlog: " << scene.images() << " images\n";
    return 0;
}

int run(int argc, const char* const* argv) {
    Arguments arguments;
    const std::unique_ptr<TCLAP::CmdLineOutput> replaced(
        arguments.cmd.getOutput());  // nobody else deletes it
    arguments.cmd.setOutput(&arguments.output_style);
    std::vector<const char*> words(argv, argv + argc);
    if (!arguments.cmd.parse(argc, words.data())) return 0;
    if (arguments.list.getValue()) {
        print_list();
        return 0;
    }
    if (arguments.output.getValue().empty()) throw std::invalid_argument("--output BASENAME is missing");
    const int gz_level = arguments.gz.getValue();
    if (gz_level < 0 || gz_level > 9)
        throw std::invalid_argument("--gz " + std::to_string(gz_level) + ": choose 0 to 9");
    return write(make_scene(scene_options(arguments)), arguments.output.getValue(), gz_level);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& e) {
        std::cerr << "flownav-make-scene: " << e.what() << '\n';
        return exit_usage;
    }
}
