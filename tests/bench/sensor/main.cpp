#include <mrpt/3rdparty/tclap/CmdLine.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "cases.h"
#include "flownav/cli/command_output.h"
#include "markdown.h"
#include "sensor_score.h"

namespace flownav::sensor_bench {
namespace {

using fidelity::cell;

constexpr auto help =
    R"(Drives through fields of posts in rendered worlds and compares the sensor with the exact truth.

flownav-sensor-bench [--section NAME]... [--first N] [--seeds N] [--seconds S] [--set section.key=value]...

  --section NAME      lens, pictures, mount, speed, turn, look or settings; all of them without it
  --first N           seed of the first post field (default 11: the settings were chosen on field 1)
  --seeds N           post fields of each case (default 2)
  --seconds S         of each drive (default 12)
  --set key=value     one setting, as for flownav-replay, on top of the recommended ones; may be repeated
  --help, --version   print this text, or the version, and exit

Prints tables in markdown. range: bias and standard deviation of the range of points on posts, of those in
steady turns for the section `turn`; missed: posts that stayed in view at 1 to 3 m for three cycles or more and
were never detected, of all such; hit: share of cycles in which a post in view at 1 to 3 m has a point; first:
cycles until its first one; false: points a cycle, within 4 m, farther than 0.2 m from any surface; gross:
farther than 0.4 m; burst: most cycles in a row with a false point; turn, speed: rms error of the turn rate, bias
and standard deviation of the speed.

Exit status:
  0  fine
  1  bad usage or configuration
)";

std::string pair_of(const Errors& errors) {
    if (errors.all.empty()) return "-";
    return cell(100 * errors.mean(), 1) + " / " + cell(100 * errors.deviation(), 1);
}

std::vector<std::string> heads() {
    return {"",       "range 1-2 m, %", "2-3 m, %", "3-4 m, %",    "steady, %",
            "missed", "hit, %",         "first",    "cycles/s",    "points",
            "false",  "gross",          "burst",    "turn, deg/s", "speed, %"};
}

std::vector<std::string> row_of(const std::string& name, const Score& score) {
    Errors near = score.range[1];
    near.all.insert(near.all.end(), score.range[2].all.begin(), score.range[2].all.end());
    const double cycles = std::max(1, score.cycles);
    return {name,
            pair_of(near),
            pair_of(score.range[3]),
            pair_of(score.range[4]),
            pair_of(score.range_steady),
            std::to_string(score.missed) + " of " + std::to_string(score.passes),
            cell(100.0 * score.seen_hit / std::max(1, score.seen), 0),
            cell(score.cycles_to_detect.mean(), 1),
            cell(score.cycles / score.seconds, 1),
            cell(score.points / cycles, 1),
            cell(score.false_points / cycles, 2),
            cell(score.gross_points / cycles, 2),
            std::to_string(score.longest_burst),
            cell(std::hypot(score.turn_error_degps.mean(), score.turn_error_degps.deviation()), 2),
            pair_of(score.speed_error)};
}

void set_all(config::Config& config, const Settings& settings) {
    for (const auto& [key, value] : settings) config::set_config_value(config, key, value);
}

struct Arguments {
    TCLAP::CmdLine command{"", ' ', "1"};
    TCLAP::MultiArg<std::string> section{"", "section", "", false, "NAME", command};
    TCLAP::ValueArg<int> first{"", "first", "", false, 11, "N", command};
    TCLAP::ValueArg<int> seeds{"", "seeds", "", false, 2, "N", command};
    TCLAP::ValueArg<double> seconds{"", "seconds", "", false, 12.0, "S", command};
    TCLAP::MultiArg<std::string> set{"", "set", "", false, "section.key=value", command};
};

config::Config base_config(Arguments& arguments) {
    config::Config config;
    set_all(config, recommended_settings());
    for (const std::string& setting : arguments.set.getValue()) {
        const auto equals = setting.find('=');
        if (equals == std::string::npos)
            throw config::ConfigError("--set " + setting + ": write section.key=value");
        config::set_config_value(config, setting.substr(0, equals), setting.substr(equals + 1));
    }
    return config;
}

/// True when the cases differ in settings only and can share their images.
bool same_pictures(const Section& section) {
    return section.name == "settings";
}

void print_section(const Section& section, Arguments& arguments, const config::Config& base) {
    std::vector<Score> scores(section.cases.size());
    const int first = arguments.first.getValue();
    for (int seed = first; seed < first + arguments.seeds.getValue(); ++seed) {
        RecordedDrive drive;
        for (std::size_t i = 0; i < section.cases.size(); ++i) {
            const Case& one = section.cases[i];
            DriveOptions options = one.drive;
            options.seed = static_cast<std::uint64_t>(seed);
            options.seconds = arguments.seconds.getValue();
            if (i == 0 || !same_pictures(section)) drive = record(options, to_simulator(one.camera));
            config::Config config = base;
            set_all(config, one.settings);
            scores[i].add(evaluate(drive, config));
        }
    }
    fidelity::Table table{heads(), {}};
    for (std::size_t i = 0; i < scores.size(); ++i)
        table.rows.push_back(row_of(section.cases[i].name, scores[i]));
    std::cout << "\n## " << section.title << "\n\n" << fidelity::to_markdown(table) << std::flush;
}

std::vector<Section> sections_of(Arguments& arguments) {
    std::vector<Section> chosen;
    const std::vector<Section> all = all_sections();
    if (arguments.section.getValue().empty()) return all;
    for (const std::string& name : arguments.section.getValue()) {
        const auto section =
            std::find_if(all.begin(), all.end(), [&](const Section& one) { return one.name == name; });
        if (section == all.end())
            throw config::ConfigError("--section " + name +
                                      ": lens, pictures, mount, speed, turn, look or settings");
        chosen.push_back(*section);
    }
    return chosen;
}

int run(Arguments& arguments) {
    try {
        if (arguments.first.getValue() < 0 || arguments.seeds.getValue() < 1 ||
            !(arguments.seconds.getValue() >= 2.0))
            throw config::ConfigError("--first must be at least 0, --seeds at least 1, --seconds at least 2");
        const config::Config base = base_config(arguments);
        for (const Section& section : sections_of(arguments)) print_section(section, arguments, base);
    } catch (const config::ConfigError& error) {
        std::cerr << "flownav-sensor-bench: " << error.what() << '\n';
        return 1;
    }
    return 0;
}

}  // namespace
}  // namespace flownav::sensor_bench

int main(int argc, char** argv) {
    flownav::sensor_bench::Arguments arguments;
    flownav::cli::CommandOutput output(arguments.command, "flownav-sensor-bench", flownav::sensor_bench::help,
                                       std::cout, std::cerr);
    if (!arguments.command.parse(argc, argv)) return output.failed() ? 1 : 0;
    return flownav::sensor_bench::run(arguments);
}
