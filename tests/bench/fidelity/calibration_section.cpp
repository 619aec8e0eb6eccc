#include "markdown.h"
#include "sections.h"

namespace flownav::fidelity {

std::string calibration_section(const Studio& studio) {
    const std::vector<Variant> variants = {
        {"true: 25 deg, 0.90 m", {}},
        {"pitch 0.5 deg too large", {{"camera.pitch_deg", "25.5"}}},
        {"pitch 0.5 deg too small", {{"camera.pitch_deg", "24.5"}}},
        {"height 2 cm too large", {{"camera.height_m", "0.92"}}},
        {"height 2 cm too small", {{"camera.height_m", "0.88"}}},
        {"roll 0.5 deg off", {{"camera.roll_deg", "0.5"}}},
    };
    Table table{{"believed camera", "T bias (%)", "T scatter (%)", "omega, cycle (deg/s)", "heading (deg)",
                 "false blocks / cycle", "near a surface (%)"},
                {}};
    const auto scores = scores_of(studio, {"carpet"}, variants).front();
    for (std::size_t i = 0; i < variants.size(); ++i) {
        const Score& s = scores[i];
        table.rows.push_back({variants[i].name, cell(s.ego.v_percent.mean(), 2),
                              cell(s.ego.v_percent.deviation(), 2), cell(s.ego.cycle_degps.rms(), 3),
                              cell(s.ego.heading_deg.mean(), 2), cell(s.blocks.false_blocks.rate(), 2),
                              cell(s.points.near.percent(), 1)});
    }
    return "## Calibration errors\n\nThe scene `carpet` with a camera that is believed to sit elsewhere. "
           "0.5 deg of pitch or 2 cm of height change T by\nabout 2.2 % each where nothing corrects "
           "them.\n\n" +
           to_markdown(table);
}

}  // namespace flownav::fidelity
