#include <fstream>

#include "flownav/config/make_state.h"
#include "flownav/io/kitti.h"
#include "lidar_pictures.h"
#include "lidar_score.h"
#include "markdown.h"
#include "real_data.h"

namespace flownav::fidelity {
namespace {

namespace fs = std::filesystem;

constexpr auto drive = "2011_09_26_drive_braking_sync";
constexpr double travel_min_m = 0.02;  // minimum travel of a cycle that can measure depth
constexpr double rate_hz = 10.0;

constexpr auto text = R"(
### Braking in a street: obstacle points against lidar

A raw KITTI drive of 78 images at 10 Hz, from 2.5 m/s to a stop, with cars left, right and ahead. A point is right when
a lidar return more than 0.3 m above the road is within 0.5 m + 5 % of its range. A cell of 0.5 m counts as an obstacle
when it holds three returns 0.3 to 2 m above the road, within `range_max_m` and where blocks look; it is found when a
point is as near. A thing is four connected cells or more. Cycles in which the car moves less than 2 cm are left out.
The second table says what became of the blocks; "above tau" is judged from the lidar, for things that stand still.

)";

config::Config raw_config() {
    config::Config config;
    config::load_config_file(config, std::string(FLOWNAV_INI_DIR) + "/kitti.ini");
    return config;
}

std::string percent(const Share& share) {
    return cell(share.percent(), 0) + " % of " + std::to_string(share.all);
}

std::string scores_table(const LidarScore& score) {
    Table table{{"", "all", "to 10 m", "10-15 m", "15-25 m"}, {}};
    const auto row = [&](const std::string& name, const Share& all, const auto& by_range) {
        table.rows.push_back({name, percent(all)});
        for (const Share& share : by_range) table.rows.back().push_back(percent(share));
    };
    row("points near lidar", score.points_near, score.near_by_range);
    row("cells found in one cycle", score.cells_found, score.found_by_range);
    table.rows.push_back({"cells found within a second", percent(score.cells_lately), "", "", ""});
    table.rows.push_back({"things found in one cycle", percent(score.things_found), "", "", ""});
    table.rows.push_back({"things found within a second", percent(score.things_lately), "", "", ""});
    table.rows.push_back({"control: points half as far again", percent(score.control_near), "", "", ""});
    table.rows.push_back({"points said to move, near lidar", percent(score.moving_near), "", "", ""});
    return to_markdown(table);
}

std::string fates_table(const LidarScore& score) {
    Table table{{"blocks that look at"}, {}};
    std::vector<BlockLabel> labels;
    for (int k = 0; k <= static_cast<int>(BlockLabel::Unjudged); ++k) {
        labels.push_back(static_cast<BlockLabel>(k));
        table.heads.emplace_back(to_string(labels.back()));
    }
    const auto row = [&](const std::string& name, const std::map<BlockLabel, int>& counts) {
        double all = 0;
        for (const auto& [label, count] : counts) all += count;
        table.rows.push_back({name + " (" + std::to_string(static_cast<int>(all)) + ")"});
        for (const BlockLabel label : labels) {
            const auto found = counts.find(label);
            table.rows.back().push_back(cell(found == counts.end() ? 0.0 : 100 * found->second / all, 1) +
                                        " %");
        }
    };
    const Labels& road = score.labels.at(Looks::AtRoad);
    const Labels& obstacle = score.labels.at(Looks::AtObstacle);
    row("the road", road.all);
    row("obstacles", obstacle.all);
    row("obstacles 0.5 px above tau", obstacle.telling);
    row("of these, beyond the search window", obstacle.beyond);
    return to_markdown(table);
}

}  // namespace

LidarScore braking_score(const fs::path& folder, const RealDataOptions& options) {
    const config::Config config = raw_config();
    io::KittiRaw images(folder, drive, rate_hz, io::kitti_mount("2011_09_26"));
    pipeline::State state = config::make_state(config);
    std::optional<LidarJudge> judge;
    std::optional<KittiLidar> lidar;
    LidarPlan plan;
    int reference = 0;
    for (int i = 0; const auto frame = images.next(); ++i) {
        if (!judge) {
            judge.emplace(frame->field.camera, config);
            lidar.emplace(folder, folder / drive, frame->field.camera.mount);
        }
        const pipeline::Step& step = pipeline::step(state, frame->field);
        if (!step.end_of_cycle) continue;
        if (std::abs(step.motion.forward_m) >= travel_min_m) {
            const auto scan_m = lidar->scan(i);
            judge->see(step, scan_m, lidar->scan(reference));
            plan.add(step, judge->view());
            if (!options.pictures.empty()) {
                write_overlay(options.pictures, i, frame->field, judge->mapper(), step, scan_m,
                              judge->view());
            }
        }
        reference = i;
    }
    if (!options.plan_svg.empty()) plan.write(options.plan_svg);
    return judge.value().result();
}

std::string braking_part(const fs::path& folder, const RealDataOptions& options) {
    if (!fs::exists(folder / drive)) return std::string(text) + "Not measured: no " + drive + ".\n";
    const LidarScore score = braking_score(folder, options);
    std::string tables = text + scores_table(score) + '\n' + fates_table(score);
    if (options.plan_svg.empty()) return tables;
    return tables +
           "\nThe plan, forward up: green cells with points that the lidar confirms, red others, blue the "
           "car's "
           "way.\n\n"
           "![Plan of the drive](" +
           options.plan_svg.filename().string() + ")\n";
}

}  // namespace flownav::fidelity
