#include "drive_pictures.h"
#include "flownav/cli/number_text.h"
#include "flownav/math/units.h"
#include "flownav/testing/write_scene.h"
#include "markdown.h"
#include "sections.h"

namespace flownav::fidelity {
namespace {

using Eigen::Vector2d;

constexpr double ahead_m = 0.5;    // half the width of the robot's path
constexpr double claimed_m = 0.1;  // [P]: the points lie on a grid of 10 cm

struct Range {
    double from_m, to_m;
};

RenderedScene loop(const Studio& studio) {
    testing::SceneOptions options;
    options.kind = testing::SceneKind::Loop;
    options.seed = studio.seed;
    options.images = 1020;
    return render_scene("loop-" + std::to_string(studio.seed), options, studio.cache);
}

double off_surface_m(const sim::World& world, const Vector2d& at_m) {
    double nearest_m = 9.0;
    for (const sim::Solid& p : world.solids) nearest_m = std::min(nearest_m, testing::distance_m(p, at_m));
    return nearest_m;
}

DriveRecord record_of(const RenderedScene& drive) {
    const testing::Scene& scene = drive.scene;
    DriveRecord record{scene.world, {}, {}, {}, {}};
    for (const Pose2& pose : testing::make_odometry(scene))
        record.odometry_m.emplace_back(pose.x_m, pose.y_m);
    run_chain(drive, {}, [&](const Moment& m) {
        const Pose2& truth = scene.poses[static_cast<std::size_t>(m.image)];
        record.truth_m.emplace_back(truth.x_m, truth.y_m);
        record.flow_m.emplace_back(m.step.T_start_robot.x_m, m.step.T_start_robot.y_m);
        const sim::World world = testing::at_time(scene.world, scene.time_s(m.image));
        for (const ObstaclePoint& point : m.step.obstacles) {
            const Vector2d at_m = transform(truth, point.position_m.head<2>());
            record.points.push_back({point.position_m.head<2>(), at_m, off_surface_m(world, at_m)});
        }
    });
    return record;
}

std::vector<std::string> range_row(const std::string& name, const std::vector<JudgedPoint>& points,
                                   const std::function<bool(const JudgedPoint&)>& chosen) {
    std::vector<double> off_m;
    Share within;
    for (const JudgedPoint& point : points) {
        if (!chosen(point)) continue;
        off_m.push_back(point.off_m);
        within.add(point.off_m < claimed_m);
    }
    return {name, std::to_string(off_m.size()), cell(median(off_m), 3), cell(within.percent(), 1)};
}

std::string range_table(const std::vector<JudgedPoint>& points) {
    Table table{{"where", "points", "median distance from a surface (m)", "within 10 cm (%)"}, {}};
    const auto is_ahead = [](const JudgedPoint& p) { return std::abs(p.in_robot_m.y()) < ahead_m; };
    for (const Range r :
         {Range{0.8, 1.5}, Range{1.5, 2.5}, Range{2.5, 3.5}, Range{3.5, 5.0}, Range{5.0, 8.0}}) {
        const std::string span = cli::fixed_text(r.from_m, 1) + "-" + cli::fixed_text(r.to_m, 1) + " m";
        const auto in_range = [&](const JudgedPoint& p) {
            return p.in_robot_m.norm() >= r.from_m && p.in_robot_m.norm() < r.to_m;
        };
        table.rows.push_back(range_row("ahead, " + span, points,
                                       [&](const JudgedPoint& p) { return in_range(p) && is_ahead(p); }));
        table.rows.push_back(range_row("aside, " + span, points,
                                       [&](const JudgedPoint& p) { return in_range(p) && !is_ahead(p); }));
    }
    return to_markdown(table);
}

/// Distance and angle between the ends of two tracks with a common start.
std::vector<std::string> end_row(const std::string& name, const Pose2& end, const Pose2& truth, double path_m,
                                 bool judged) {
    const double off_m = std::hypot(end.x_m - truth.x_m, end.y_m - truth.y_m);
    const double turn_deg = deg(wrap_angle(end.yaw_rad - truth.yaw_rad));
    const auto target = [judged](double limit) {
        return judged ? std::optional<Target>(below(limit)) : std::nullopt;
    };
    return {name, cell(off_m, 3), cell(100.0 * off_m / path_m, 2, target(0.15)),
            cell(turn_deg, 2, target(0.1))};
}

std::string ends_table(const RenderedScene& drive) {
    Pose2 flow;
    run_chain(drive, {}, [&](const Moment& m) { flow = m.step.T_start_robot; });
    const testing::Scene& scene = drive.scene;
    double path_m = 0.0;
    for (std::size_t i = 1; i < scene.poses.size(); ++i) {
        path_m += std::hypot(scene.poses[i].x_m - scene.poses[i - 1].x_m,
                             scene.poses[i].y_m - scene.poses[i - 1].y_m);
    }
    Table table{{"track", "end off by (m)", "% of the path", "heading (deg)"}, {}};
    table.rows.push_back(end_row("flow odometry", flow, scene.poses.back(), path_m, true));
    table.rows.push_back(end_row("wheel odometry, scale 0.6 % and yaw 1 % off",
                                 testing::make_odometry(scene).back(), scene.poses.back(), path_m, false));
    return "Path: " + cli::fixed_text(path_m, 1) + " m.\n\n" + to_markdown(table);
}

}  // namespace

std::string paper_section(const Studio& studio, const std::filesystem::path& folder,
                          const std::string& stem) {
    const RenderedScene drive = loop(studio);
    const DriveRecord record = record_of(drive);
    write_text(folder / (stem + "-drive.svg"), paths_picture(record));
    write_text(folder / (stem + "-points.svg"), points_picture(record));
    return "## The paper's own claims\n\n### Flow against odometry over a drive (its Fig. 9)\n\nOnce around "
           "a "
           "railing and a chair, on carpet, 0.4 m/s, quarter turns of 1 m radius.\n\n" +
           ends_table(drive) + "![Paths of the drive](" + stem +
           "-drive.svg)\n\n### Points of a 10 cm grid, 1.5 to 3.5 m ahead and to 8 m aside\n\nEvery obstacle "
           "point of that drive, in the robot's frame at the end of its cycle, before any fusion.\nAhead: "
           "within 0.5 m of the robot's line.\n\n" +
           range_table(record.points) + "![Obstacle points of the drive](" + stem + "-points.svg)\n\n";
}

}  // namespace flownav::fidelity
