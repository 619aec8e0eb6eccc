#include "sections.h"
#include "targets.h"

namespace flownav::fidelity {
namespace {

std::vector<Variant> variants() {
    return {
        {"default", {}},
        {"printed form: at the block, integer, yaw, r = 4",
         {{"motion.geometry", "block"},
          {"flow.subpixel", "none"},
          {"motion.motion_model", "yaw"},
          {"motion.cycle_images", "4"}}},
        {"printed form, at the mid-point",
         {{"flow.subpixel", "none"}, {"motion.motion_model", "yaw"}, {"motion.cycle_images", "4"}}},
        {"at the block", {{"motion.geometry", "block"}}},
        {"integer vectors", {{"flow.subpixel", "none"}}},
        {"parabola", {{"flow.subpixel", "parabola"}}},
        {"yaw alone", {{"motion.motion_model", "yaw"}}},
        {"pyramidal Lucas-Kanade", {{"flow.matcher", "lk"}}},
        {"brightness not compensated", {{"flow.brightness", "off"}}},
        {"pitch learnt on the way", {{"motion.pitch_online", "true"}}},
        {"no sifting", {{"flow.confidence_min", "0"}}},
        {"no elimination", {{"obstacles.lambda_px", "20"}}},
        {"no neighbours", {{"obstacles.neighbours", "0"}}},
        {"no sifting, no elimination, no neighbours",
         {{"flow.confidence_min", "0"}, {"obstacles.lambda_px", "20"}, {"obstacles.neighbours", "0"}}},
        {"700 blocks", {{"flow.blocks", "700"}}},
        {"r = 4", {{"motion.cycle_images", "4"}}},
        {"r = 8", {{"motion.cycle_images", "8"}}},
    };
}

std::string table_of(const std::string& scene, const std::vector<Variant>& rows,
                     const std::vector<Score>& scores) {
    const Targets targets = targets_of(scene);
    Table table{{"variant", "omega, image (deg/s)", "omega, cycle (deg/s)", "T bias (%)", "T scatter (%)",
                 "ok (%)", "heading (deg)", "false blocks / cycle", "ghost points / cycle",
                 "detected, textured (%)", "near a surface (%)"},
                {}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Score& s = scores[i];
        table.rows.push_back({rows[i].name, cell(s.ego.omega_degps.rms(), 3, targets.omega_image_degps),
                              cell(s.ego.cycle_degps.rms(), 3, targets.omega_cycle_degps),
                              cell(s.ego.v_percent.mean(), 2, targets.t_bias_percent),
                              cell(s.ego.v_percent.deviation(), 2, targets.t_scatter_percent),
                              cell(s.ego.ok.percent(), 0), cell(s.ego.heading_deg.mean(), 2),
                              cell(s.blocks.false_blocks.rate(), 2, targets.false_per_cycle),
                              cell(s.points.ghosts.rate(), 2, targets.ghosts_per_cycle),
                              cell(s.blocks.detected_textured.percent(), 0),
                              cell(s.points.near.percent(), 1)});
    }
    return to_markdown(table);
}

}  // namespace

std::string ablation_section(const Studio& studio) {
    const std::vector<std::string> scenes = {"carpet",       "turns",          "tiles",   "lino",
                                             "vibration015", "exposure-steps", "flicker", "mover45"};
    const std::vector<Variant> all = variants();
    const auto scores = scores_of(studio, scenes, all);
    std::string text =
        "## Ablation\n\nThe default with one thing changed or left out. Lucas-Kanade is OpenCV's, pyramidal, "
        "behind the same back end.\n\n";
    for (std::size_t i = 0; i < scenes.size(); ++i)
        text += "### " + scenes[i] + "\n\n" + table_of(scenes[i], all, scores[i]);
    return text;
}

}  // namespace flownav::fidelity
