#include <mrpt/3rdparty/tclap/CmdLine.h>

#include <iostream>
#include <sstream>

#include "flownav/cli/command_output.h"
#include "flownav/testing/presets.h"
#include "real_data.h"
#include "row.h"
#include "sections.h"

namespace flownav::fidelity {
namespace {

constexpr auto help = R"(Renders named scenes, runs the chain over them and compares with the exact truth.

flownav-fidelity [--scene NAME[,NAME]...] [--seed N[,N]...] [--images M] [--set section.key=value]...
                 [--config FILE.ini] [--wheels] [--detail] [--cache DIR]
flownav-fidelity --page FILE.md [--seed N] [--cache DIR]
flownav-fidelity --real-drives DIR

  --scene NAME,...    scenes of flownav-make-scene --list; all of them without it
  --seed N,...        seeds; the figures of several are added up (default 1)
  --images M          images of each drive instead of the scene's own number
  --config FILE.ini   settings, as for flownav-replay
  --set key=value     one setting, as for flownav-replay; may be repeated
  --wheels            also give the chain the wheel odometry of the robot, with its usual errors
  --detail            also print the blocks found by kind of thing and range
  --page FILE.md      write the whole page of figures instead, with the first seed and the default settings
  --real-drives DIR   print what the chain makes of the recordings where FLOWNAV_DATA points, and draw obstacle points
                      and lidar on camera images in DIR
  --cache DIR         keep rendered pictures there and use them again
  --help, --version   print this text, or the version, and exit

One row per scene. om: turn rate, rms error per image and of the mean over a cycle; T: speed of cycles that measured it;
end, head: odometry at the end; ghosts: points far from every surface per cycle with points; false: obstacle blocks
that show only floor; detect: blocks that exceed tau by 0.5 px found, of text.: of
those on richly textured things; 1-2m ..: median distance of points from surfaces;
chair: found in one cycle at 2-4 m; mapP, mapR: precision and recall of the fused map; cover, images, |om|: largest share
of blocks on the mover, images where it is above half, mean magnitude of the error of omega there.

Exit status:
  0  fine
  1  bad usage or configuration
  3  a page, picture or cache cannot be written, or a recording is damaged
)";

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, ',');)
        if (!part.empty()) parts.push_back(part);
    return parts;
}

struct Arguments {
    TCLAP::CmdLine command{"", ' ', "1"};
    TCLAP::ValueArg<std::string> scene{"", "scene", "", false, "", "NAME", command};
    TCLAP::ValueArg<std::string> seed{"", "seed", "", false, "1", "N", command};
    TCLAP::ValueArg<int> images{"", "images", "", false, 0, "M", command};
    TCLAP::ValueArg<std::string> config{"", "config", "", false, "", "FILE.ini", command};
    TCLAP::MultiArg<std::string> set{"", "set", "", false, "section.key=value", command};
    TCLAP::SwitchArg wheels{"", "wheels", "", command};
    TCLAP::SwitchArg detail{"", "detail", "", command};
    TCLAP::ValueArg<std::string> page{"", "page", "", false, "", "FILE.md", command};
    TCLAP::ValueArg<std::string> real{"", "real-drives", "", false, "", "DIR", command};
    TCLAP::ValueArg<std::string> cache{"", "cache", "", false, "", "DIR", command};
};

config::Config config_of(Arguments& arguments) {
    config::Config config;
    if (arguments.config.isSet()) config::load_config_file(config, arguments.config.getValue());
    for (const std::string& setting : arguments.set.getValue()) {
        const auto equals = setting.find('=');
        if (equals == std::string::npos)
            throw config::ConfigError("--set " + setting + ": write section.key=value");
        config::set_config_value(config, setting.substr(0, equals), setting.substr(equals + 1));
    }
    return config;
}

std::vector<std::string> scenes_of(Arguments& arguments) {
    std::vector<std::string> names = split(arguments.scene.getValue());
    if (names.empty())
        for (const testing::Preset& preset : testing::all_presets()) names.emplace_back(preset.name);
    for (const std::string& name : names) {
        if (!testing::preset(name, 1))
            throw config::ConfigError("--scene " + name +
                                      " is unknown: flownav-make-scene --list prints them");
    }
    return names;
}

std::uint64_t seed_of(const std::string& text) {
    std::size_t used = 0;
    std::uint64_t seed = 0;
    try {
        seed = std::stoull(text, &used);
    } catch (const std::exception&) {
        used = 0;
    }
    if (used != text.size()) throw config::ConfigError("--seed " + text + ": choose whole numbers");
    return seed;
}

Score score_of(const std::string& name, Arguments& arguments, const config::Config& config) {
    Score score;
    for (const std::string& seed : split(arguments.seed.getValue())) {
        testing::SceneOptions options = testing::preset(name, seed_of(seed)).value();
        if (arguments.images.isSet()) options.images = arguments.images.getValue();
        std::string title = name;
        title.append("-").append(seed);
        RenderedScene drive = render_scene(title, options, arguments.cache.getValue());
        drive.wheels = arguments.wheels.getValue();
        score.add(evaluate(drive, config));
    }
    return score;
}

void print_rows(Arguments& arguments) {
    const config::Config config = config_of(arguments);
    const auto names = scenes_of(arguments);
    std::cout << row_heads() << std::endl;
    for (const std::string& name : names) {
        const Score score = score_of(name, arguments, config);
        std::cout << row_of(name, score) << std::endl;
        if (arguments.detail.isSet()) std::cout << detection_of(score) << std::endl;
    }
}

void print_real_drives(const std::filesystem::path& pictures) {
    std::filesystem::create_directories(pictures);
    RealDataOptions options;
    options.pictures = pictures;
    std::cout << real_data_report(options);
}

int run(Arguments& arguments) {
    try {
        if (!arguments.cache.getValue().empty())
            std::filesystem::create_directories(arguments.cache.getValue());
        if (arguments.real.isSet()) {
            print_real_drives(arguments.real.getValue());
        } else if (arguments.page.isSet()) {
            const Studio studio{arguments.cache.getValue(), seed_of(arguments.seed.getValue())};
            write_page(studio, arguments.page.getValue());
        } else {
            print_rows(arguments);
        }
    } catch (const config::ConfigError& error) {
        std::cerr << "flownav-fidelity: " << error.what() << '\n';
        return 1;
    } catch (const std::invalid_argument& error) {
        std::cerr << "flownav-fidelity: " << error.what() << '\n';
        return 1;
    } catch (const std::runtime_error& error) {
        std::cerr << "flownav-fidelity: " << error.what() << '\n';
        return 3;
    }
    return 0;
}

}  // namespace
}  // namespace flownav::fidelity

int main(int argc, char** argv) {
    flownav::fidelity::Arguments arguments;
    flownav::cli::CommandOutput output(arguments.command, "flownav-fidelity", flownav::fidelity::help,
                                       std::cout, std::cerr);
    if (!arguments.command.parse(argc, argv)) return output.failed() ? 1 : 0;
    return flownav::fidelity::run(arguments);
}
