#include <mrpt/3rdparty/tclap/CmdLine.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "contact_score.h"
#include "flownav/cli/command_output.h"
#include "flownav/math/units.h"
#include "markdown.h"

namespace flownav::contact_bench {
namespace {

using fidelity::cell;

constexpr auto help =
    R"(Drives past things of one colour in rendered worlds and compares the contact scan with the exact truth.

flownav-contact-bench [--things NAME]... [--floor NAME]... [--first N] [--seeds N] [--seconds S]
                      [--set section.key=value]...

  --things NAME       posts, boxes, walls or mats (free floor with tape and mats); all of them without it
  --floor NAME        carpet, tiles, lino or plain; all of them without it
  --first N           seed of the first world (default 11: the settings were chosen on worlds 1 to 3)
  --seeds N           worlds of each row (default 2)
  --seconds S         of each drive (default 12)
  --set key=value     one setting, as for flownav-replay; may be repeated
  --help, --version   print this text, or the version, and exit

missed: things that stayed in view at 1 to 3 m for three scans or more and never had a contact within 0.2 m, of
all such; hit: share of the scans in which a thing in view has one; blocks: the same for the points of the blocks;
false: contacts a scan farther than 0.3 m and 12 % from any surface; gross: 0.5 m and 25 %; range: median and
standard deviation of the contacts' relative error; wrong free: strips that face a thing nearer than 3 m and are
free beyond it; decided: strips within 40 degrees that are free, or end at a contact, up to 2 m.

Exit status:
  0  fine
  1  bad usage or configuration
)";

struct Arguments {
    TCLAP::CmdLine command{"", ' ', "1"};
    TCLAP::MultiArg<std::string> things{"", "things", "", false, "NAME", command};
    TCLAP::MultiArg<std::string> floor{"", "floor", "", false, "NAME", command};
    TCLAP::ValueArg<int> first{"", "first", "", false, 11, "N", command};
    TCLAP::ValueArg<int> seeds{"", "seeds", "", false, 2, "N", command};
    TCLAP::ValueArg<double> seconds{"", "seconds", "", false, 12.0, "S", command};
    TCLAP::MultiArg<std::string> set{"", "set", "", false, "section.key=value", command};
};

sim::CameraSimParams camera() {
    sim::CameraSimParams params;
    CameraModel& c = params.camera;
    c.width_px = 640;
    c.height_px = 480;
    c.fx_px = c.fy_px = 320.0;
    c.cx_px = 319.5;
    c.cy_px = 239.5;
    c.mount.height_m = 0.6;
    c.mount.pitch_rad = 18.0 * degree_rad;
    params.effects = {1.0, 0.0, 0.2, 0.5, 2.0, 0.05, 0.05, 1};
    return params;
}

const std::vector<std::pair<std::string, sim::Surface>>& floors() {
    static const std::vector<std::pair<std::string, sim::Surface>> all = {{"carpet", sim::Surface::Carpet},
                                                                          {"tiles", sim::Surface::Tiles},
                                                                          {"lino", sim::Surface::Lino},
                                                                          {"plain", sim::Surface::Plain}};
    return all;
}

bool is_chosen(const std::vector<std::string>& chosen, const std::string& name) {
    return chosen.empty() || std::find(chosen.begin(), chosen.end(), name) != chosen.end();
}

std::vector<std::string> row_of(const std::string& things, const std::string& floor, const Score& s) {
    std::vector<double> errors = s.range_error;
    std::sort(errors.begin(), errors.end());
    const auto n = static_cast<double>(std::max<std::size_t>(errors.size(), 1));
    double sum = 0.0;
    double sum2 = 0.0;
    for (const double e : errors) {
        sum += e;
        sum2 += e * e;
    }
    const double median = errors.empty() ? NAN : errors[errors.size() / 2];
    const double scans = std::max(1, s.scans);
    return {
        things,
        floor,
        std::to_string(s.missed) + " of " + std::to_string(s.passes),
        cell(100.0 * s.hit / std::max(1, s.seen), 0),
        cell(100.0 * s.points_hit / std::max(1, s.seen), 0),
        cell(s.false_strips / scans, 2),
        cell(s.gross_strips / scans, 2),
        cell(100 * median, 1) + " / " + cell(100 * std::sqrt(std::max(0.0, sum2 / n - sum * sum / n / n)), 1),
        cell(100.0 * s.wrong_free / std::max(1, s.facing), 1),
        cell(100.0 * s.decided / std::max(1, s.strips), 0),
        std::to_string(s.scans) + " + " + std::to_string(s.closed),
        cell(s.fit_share / scans, 2),
        cell(s.vignetting / scans, 2)};
}

int run(Arguments& a) {
    try {
        config::Config config;
        for (const auto& [key, value] :
             {std::pair("motion.travel_m", "0.16"), {"flow.focus_exclusion", "0.12"}})
            config::set_config_value(config, key, value);
        for (const std::string& setting : a.set.getValue()) {
            const auto equals = setting.find('=');
            if (equals == std::string::npos)
                throw config::ConfigError("--set " + setting + ": write section.key=value");
            config::set_config_value(config, setting.substr(0, equals), setting.substr(equals + 1));
        }
        fidelity::Table table{{"things", "floor", "missed", "hit, %", "blocks, %", "false", "gross",
                               "range, %", "wrong free, %", "decided, %", "scans", "fit", "fall-off"},
                              {}};
        for (const Things things : {Things::Posts, Things::Boxes, Things::Walls, Things::Mats}) {
            for (const auto& [name, surface] : floors()) {
                if (!is_chosen(a.things.getValue(), to_string(things)) ||
                    !is_chosen(a.floor.getValue(), name))
                    continue;
                Score score;
                for (int seed = a.first.getValue(); seed < a.first.getValue() + a.seeds.getValue(); ++seed) {
                    SceneOptions options;
                    options.things = things;
                    options.floor = surface;
                    options.seconds = a.seconds.getValue();
                    options.seed = static_cast<std::uint64_t>(seed);
                    score.add(evaluate(record(options, camera()), config));
                }
                table.rows.push_back(row_of(to_string(things), name, score));
            }
        }
        std::cout << fidelity::to_markdown(table) << std::flush;
    } catch (const config::ConfigError& error) {
        std::cerr << "flownav-contact-bench: " << error.what() << '\n';
        return 1;
    }
    return 0;
}

}  // namespace
}  // namespace flownav::contact_bench

int main(int argc, char** argv) {
    flownav::contact_bench::Arguments arguments;
    flownav::cli::CommandOutput output(arguments.command, "flownav-contact-bench",
                                       flownav::contact_bench::help, std::cout, std::cerr);
    if (!arguments.command.parse(argc, argv)) return output.failed() ? 1 : 0;
    return flownav::contact_bench::run(arguments);
}
