#include "row.h"

#include <array>
#include <vector>

#include "flownav/cli/number_text.h"

namespace flownav::fidelity {
namespace {

constexpr std::size_t name_width = 16;

struct Column {
    const char* head;
    const char* unit;
    std::size_t width;
    int decimals;
    double (*value)(const Score& score);
};

const std::vector<Column>& columns() {
    static const std::vector<Column> all = {
        {"ok", "%", 4, 0, [](const Score& s) { return s.ego.ok.percent(); }},
        {"om/img", "deg/s", 7, 3, [](const Score& s) { return s.ego.omega_degps.rms(); }},
        {"om/cyc", "deg/s", 7, 3, [](const Score& s) { return s.ego.cycle_degps.rms(); }},
        {"om bias", "deg/s", 8, 3, [](const Score& s) { return s.ego.omega_degps.mean(); }},
        {"pitch", "deg/s", 7, 3, [](const Score& s) { return s.ego.pitch_degps.rms(); }},
        {"T bias", "%", 7, 2, [](const Score& s) { return s.ego.v_percent.mean(); }},
        {"T sd", "%", 6, 2, [](const Score& s) { return s.ego.v_percent.deviation(); }},
        {"T meas", "%", 7, 0, [](const Score& s) { return s.ego.v_measured.percent(); }},
        {"end", "%", 6, 2, [](const Score& s) { return s.ego.end_percent.mean(); }},
        {"head", "deg", 7, 2, [](const Score& s) { return s.ego.heading_deg.mean(); }},
        {"ghosts", "/cyc", 7, 2, [](const Score& s) { return s.points.ghosts.rate(); }},
        {"false", "blk/cyc", 8, 2, [](const Score& s) { return s.blocks.false_blocks.rate(); }},
        {"detect", "%", 7, 1, [](const Score& s) { return s.blocks.detected.percent(); }},
        {"of text.", "%", 9, 1, [](const Score& s) { return s.blocks.detected_textured.percent(); }},
        {"near", "%", 6, 1, [](const Score& s) { return s.points.near.percent(); }},
        {"1-2m", "m", 6, 3, [](const Score& s) { return median(s.points.surface_error_m[0]); }},
        {"2-3m", "m", 6, 3, [](const Score& s) { return median(s.points.surface_error_m[1]); }},
        {"3-4m", "m", 6, 3, [](const Score& s) { return median(s.points.surface_error_m[2]); }},
        {"objs", "%", 5, 0, [](const Score& s) { return s.points.objects.percent(); }},
        {"chair", "%", 6, 0, [](const Score& s) { return s.points.chairs_in_a_cycle.percent(); }},
        {"mapP", "%", 6, 1, [](const Score& s) { return s.map.precise.percent(); }},
        {"mapR", "%", 6, 1, [](const Score& s) { return s.map.found.percent(); }},
        {"cover", "max %", 6, 0, [](const Score& s) { return 100.0 * s.ego.covered_most; }},
        {"images", ">50%", 7, 0,
         [](const Score& s) { return static_cast<double>(s.ego.covered_degps.count); }},
        {"|om|", "deg/s", 7, 3, [](const Score& s) { return s.ego.covered_degps.mean_magnitude(); }},
    };
    return all;
}

std::string right(const std::string& text, std::size_t width) {
    return text.size() >= width ? ' ' + text : std::string(width - text.size(), ' ') + text;
}

std::string left(const std::string& text, std::size_t width) {
    return text.size() >= width ? text : text + std::string(width - text.size(), ' ');
}

std::string labels_line(const std::string& name, const std::map<BlockLabel, std::int64_t>& labels) {
    std::string line = left(name, name_width);
    for (const auto& [label, count] : labels)
        line += right(std::string(to_string(label)) + ' ' + std::to_string(count), 18);
    return line;
}

}  // namespace

std::string row_heads() {
    std::string heads = left("scene", name_width);
    std::string units = left("", name_width);
    for (const Column& column : columns()) {
        heads += right(column.head, column.width);
        units += right(column.unit, column.width);
    }
    return heads + '\n' + units;
}

std::string row_of(const std::string& name, const Score& score) {
    std::string row = left(name, name_width);
    for (const Column& column : columns()) {
        const std::string text = cli::fixed_text(column.value(score), column.decimals);
        row += right(text.empty() ? "-" : text, column.width);
    }
    return row;
}

std::string detection_of(const Score& score) {
    std::string text = left("  blocks to", name_width);
    for (const double range_m : range_ends_m) text += right(cli::fixed_text(range_m, 1) + " m", 16);
    for (const auto& [kind, shares] : score.blocks.by_kind) {
        text += '\n' + left(std::string("  ") + sim::to_string(kind), name_width);
        for (const Share& share : shares) {
            const std::string counts = std::to_string(share.hits) + " of " + std::to_string(share.all);
            text += right(share.all > 0 ? counts : "-", 16);
        }
    }
    return text + '\n' + labels_line("  all", score.blocks.labels) + '\n' +
           labels_line("  textured", score.blocks.fates_textured);
}

}  // namespace flownav::fidelity
