#include <fstream>
#include <stdexcept>

#include "sections.h"

namespace flownav::fidelity {
namespace {

constexpr auto introduction = R"(# Fidelity

How true the sensor is. `tests/bench/fidelity/run.sh` renders the scenes below from their seed, runs the chain over them
and writes this page; the same code writes the same page. Every scene is run with the one default configuration unless
a table says otherwise, and compared with the exact truth of the renderer (tests/support).

A figure stands beside its target: `0.012 < 0.025`. **Bold** figures miss it. The targets are those of a very good
implementation; "-" means that there was nothing to measure.

)";

}  // namespace

void write_text(const std::filesystem::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

void write_page(const Studio& studio, const std::filesystem::path& file) {
    std::string page = introduction;
    studio.say("Scenes");
    page += scenes_section(studio);
    studio.say("Ablation");
    page += ablation_section(studio);
    studio.say("Calibration");
    page += calibration_section(studio);
    studio.say("Jumps");
    page += jumps_section(studio);
    studio.say("Claims of the paper");
    page += paper_section(studio, file.parent_path(), file.stem().string());
    page += real_data_section();
    while (page.size() > 1 && page[page.size() - 2] == '\n') page.pop_back();
    write_text(file, page);
}

}  // namespace flownav::fidelity
