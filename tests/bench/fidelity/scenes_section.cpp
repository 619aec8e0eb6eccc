#include "flownav/cli/number_text.h"
#include "flownav/testing/presets.h"
#include "sections.h"
#include "targets.h"

namespace flownav::fidelity {
namespace {

struct Row {
    std::string name;
    Score score;
    Targets targets;
};

std::string meanings() {
    Table table{{"scene", "what it is"}, {}};
    for (const testing::Preset& preset : testing::all_presets())
        table.rows.push_back({preset.name, preset.meaning});
    std::string text = to_markdown(table);
    return text.replace(text.find("--:|"), 4, "---|");
}

std::string ego_motion(const std::vector<Row>& rows) {
    Table table{{"scene", "omega, image (deg/s)", "omega, cycle (deg/s)", "pitch rate (deg/s)", "T bias (%)",
                 "T scatter (%)", "T measured (%)", "ok (%)", "end (% of path)", "heading (deg)"},
                {}};
    for (const auto& [name, score, targets] : rows) {
        const EgoScore& e = score.ego;
        table.rows.push_back(
            {name, cell(e.omega_degps.rms(), 3, targets.omega_image_degps),
             cell(e.cycle_degps.rms(), 3, targets.omega_cycle_degps), cell(e.pitch_degps.rms(), 3),
             cell(e.v_percent.mean(), 2, targets.t_bias_percent),
             cell(e.v_percent.deviation(), 2, targets.t_scatter_percent), cell(e.v_measured.percent(), 0),
             cell(e.ok.percent(), 0), cell(e.end_percent.mean(), 2), cell(e.heading_deg.mean(), 2)});
    }
    return to_markdown(table);
}

std::string obstacles(const std::vector<Row>& rows) {
    Table table{{"scene", "false blocks / cycle", "ghost points / cycle", "detected (%)",
                 "detected, textured (%)", "near a surface (%)", "error 1-2 m", "error 2-3 m", "error 3-4 m",
                 "chair in a cycle (%)", "objects found (%)", "map precision (%)", "map recall (%)"},
                {}};
    for (const auto& [name, score, targets] : rows) {
        const PointScore& p = score.points;
        table.rows.push_back(
            {name, cell(score.blocks.false_blocks.rate(), 2, targets.false_per_cycle),
             cell(p.ghosts.rate(), 2, targets.ghosts_per_cycle), cell(score.blocks.detected.percent(), 0),
             cell(score.blocks.detected_textured.percent(), 0, targets.detected_percent),
             cell(p.near.percent(), 1), cell(median(p.surface_error_m[0]), 3, targets.error_1_2_m),
             cell(median(p.surface_error_m[1]), 3, targets.error_2_3_m),
             cell(median(p.surface_error_m[2]), 3, targets.error_3_4_m),
             cell(p.chairs_in_a_cycle.percent(), 0, targets.chair_percent), cell(p.objects.percent(), 0),
             cell(score.map.precise.percent(), 0, targets.map_precise_percent),
             cell(score.map.found.percent(), 0, targets.map_found_percent)});
    }
    return to_markdown(table);
}

std::string detection(const std::vector<Row>& rows) {
    BlockScore all;
    for (const Row& row : rows) all.add(row.score.blocks);
    Table table{{"kind"}, {}};
    double from_m = 0.0;
    for (const double to_m : range_ends_m) {
        table.heads.push_back(cli::fixed_text(from_m, 1) + "-" + cli::fixed_text(to_m, 1) + " m");
        from_m = to_m;
    }
    table.heads.emplace_back("all");
    for (const auto& [kind, shares] : all.by_kind) {
        std::vector<std::string> cells = {sim::to_string(kind)};
        Share total;
        for (const Share& share : shares) {
            total.add(share);
            cells.push_back(share.all == 0 ? "-"
                                           : cell(share.percent(), 0) + " % of " + std::to_string(share.all));
        }
        cells.push_back(cell(total.percent(), 0) + " % of " + std::to_string(total.all));
        table.rows.push_back(cells);
    }
    return to_markdown(table);
}

std::string labels(const std::vector<Row>& rows) {
    BlockScore all;
    for (const Row& row : rows) all.add(row.score.blocks);
    Table table{{"fate", "all", "textured"}, {}};
    for (const auto& [label, count] : all.labels) {
        const Share whole{count, all.detected.all};
        const Share textured{all.fates_textured[label], all.detected_textured.all};
        table.rows.push_back(
            {to_string(label), cell(whole.percent(), 1) + " %", cell(textured.percent(), 1) + " %"});
    }
    return to_markdown(table);
}

std::string movers(const std::vector<Row>& rows) {
    Table table{{"scene", "largest cover (% of the blocks)", "images above 50 %",
                 "mean error of omega there (deg/s)", "heading at the end (deg)", "near a surface (%)"},
                {}};
    for (const auto& [name, score, targets] : rows) {
        if (score.ego.covered_most <= 0.0) continue;
        table.rows.push_back({name, cell(100.0 * score.ego.covered_most, 0),
                              std::to_string(score.ego.covered_degps.count),
                              cell(score.ego.covered_degps.mean_magnitude(), 3, targets.covered_degps),
                              cell(score.ego.heading_deg.mean(), 2, targets.heading_deg),
                              cell(score.points.near.percent(), 1)});
    }
    return to_markdown(table);
}

}  // namespace

std::string scenes_section(const Studio& studio) {
    std::vector<std::string> names;
    for (const testing::Preset& preset : testing::all_presets()) names.emplace_back(preset.name);
    const auto scores = scores_of(studio, names, {{"default", {}}});
    std::vector<Row> rows;
    for (std::size_t i = 0; i < names.size(); ++i)
        rows.push_back({names[i], scores[i].front(), targets_of(names[i])});
    const auto with_wheels = scores_of(studio, {"plain"}, {{"wheels", {}, true}});
    rows.push_back({"plain, wheels", with_wheels.front().front(), targets_of("plain, wheels")});
    return "## Scenes\n\nWhat they share: 25 Hz, 0.4 m/s, 200 images or more, a weave of up to 20 deg/s past "
           "rails, chairs, poles of\n5 cm, boxes of 15 cm and higher, drums and walls; 640x480 pixels, noise "
           "of 2.5 grey levels, a camera 0.9 m high, 25 deg\ndown, 55 deg wide. `flownav-make-scene --preset "
           "NAME --seed " +
           std::to_string(studio.seed) +
           "` writes each as a rawlog. \"plain, wheels\" is the scene plain, where the chain also gets the "
           "odometry of the\nwheels, with its usual errors.\n\n" +
           meanings() +
           "## Ego-motion and odometry\n\nRoot mean square error of the turn rate per image and of its mean "
           "over a cycle; T over the cycles that measured it; the\nodometry at the end of each drive (3 "
           "m).\n\n" +
           ego_motion(rows) +
           "## Obstacles\n\nFalse blocks show nothing but floor. Ghosts are points farther than 0.5 m (or 15 "
           "% of their range) from everything.\nDetected: of the blocks whose true value of (13) exceeds tau "
           "by half a pixel, whatever they show, blank walls and\npainted wood included, and of those on "
           "richly textured things. Errors are medians of the horizontal distance of\npoints from the "
           "nearest surface, metres.\n\n" +
           obstacles(rows) +
           "## Detection by range and kind\n\nThe same blocks of all scenes together, by what they show and "
           "how far it is. Poles and rails are thinner than a\nblock; walls are blank plaster above a dark "
           "skirting board.\n\n" +
           detection(rows) + "What becomes of these blocks:\n\n" + labels(rows) + "## Movers\n\n" +
           movers(rows);
}

}  // namespace flownav::fidelity
