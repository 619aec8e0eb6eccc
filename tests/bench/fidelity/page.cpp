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

/// Reduces runs of empty lines to one and removes them at the end.
std::string tidy(const std::string& text) {
    std::string result;
    for (const char c : text) {
        const std::size_t n = result.size();
        const bool second_empty_line = c == '\n' && n > 1 && result[n - 1] == '\n' && result[n - 2] == '\n';
        if (!second_empty_line) result += c;
    }
    while (result.size() > 1 && result[result.size() - 2] == '\n') result.pop_back();
    return result;
}

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
    studio.say("Real drives");
    page += real_data_section(file.parent_path(), file.stem().string());
    write_text(file, tidy(page));
}

}  // namespace flownav::fidelity
