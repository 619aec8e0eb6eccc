#include "map_panel.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "flownav/cli/number_text.h"
#include "flownav/report/cause_style.h"
#include "flownav/report/contact_segments.h"
#include "ink.h"

namespace flownav::view {

namespace {

using Eigen::Vector2d;

constexpr int legend_px = 2 * line_px + 6;
constexpr double behind_share = 0.25;  // share of the height behind the robot
constexpr double wanted_lines = 8.0;

struct Projection {
    cv::Size size;
    double px_per_m = 1.0;
    cv::Point robot_px;

    cv::Point at(const Vector2d& p_m) const {
        const double far = 30000.0;  // limit of OpenCV's drawing coordinates
        return {cvRound(std::clamp(robot_px.x - p_m.y() * px_per_m, -far, far)),
                cvRound(std::clamp(robot_px.y - p_m.x() * px_per_m, -far, far))};
    }
};

Projection projection_of(const cv::Size& panel, double ahead_m) {
    Projection p;
    p.size = {panel.width, std::max(8, panel.height - legend_px)};
    p.robot_px = {panel.width / 2, cvRound(p.size.height * (1.0 - behind_share))};
    p.px_per_m = p.robot_px.y / ahead_m;
    return p;
}

void draw_grid(cv::Mat& picture, const Projection& p) {
    const double step_m = round_step(p.size.height / p.px_per_m / wanted_lines);
    const int decimals = step_m < 1.0 ? 1 : 0;
    const int lines = static_cast<int>(std::max(p.size.width, p.size.height) / p.px_per_m / step_m) + 2;
    for (int i = -lines; i <= lines; ++i) {
        const cv::Point cross = p.at({i * step_m, i * step_m});
        cv::line(picture, {0, cross.y}, {picture.cols, cross.y}, i == 0 ? grey : faint);
        cv::line(picture, {cross.x, 0}, {cross.x, picture.rows}, i == 0 ? grey : faint);
    }
    for (int i = -lines; i <= lines; ++i) {
        const cv::Point cross = p.at({i * step_m, i * step_m});
        const std::string text = cli::fixed_text(i * step_m, decimals);
        if (cross.y > 20 && cross.y < p.size.height - 6)
            write_text(picture, {4, cross.y - 3}, text + " m", grey, 0.4);
        if (i != 0 && cross.x > 60 && cross.x < picture.cols - 34)
            write_text(picture, {cross.x + 3, p.size.height - 5}, text, grey, 0.4);
    }
    write_text(picture, {picture.cols - 248, 15}, "robot frame in metres, ahead is up", grey, 0.4);
}

/// T_robot_start by flow odometry.
Pose2 robot_start(const Frame& frame) {
    return inverse(frame.step.T_start_robot);
}

void draw_scan(cv::Mat& picture, const Projection& p, const CycleResult& cycle, const Pose2& T_robot_cycle) {
    const VirtualScan& scan = cycle.scan;
    cv::Mat tinted = picture.clone();
    const cv::Point origin = p.at(transform(T_robot_cycle, {0, 0}));
    for (std::size_t i = 0; i < scan.beams.size(); ++i) {
        const Beam& beam = scan.beams[i];
        if (beam.kind == BeamKind::Unknown) continue;
        const double middle = scan.first_bearing_rad + static_cast<double>(i) * scan.step_rad;
        const auto end = [&](double bearing) {
            const Vector2d at = beam.range_m * Vector2d(std::cos(bearing), std::sin(bearing));
            return p.at(transform(T_robot_cycle, at));
        };
        const cv::Point right = end(middle - scan.step_rad / 2);
        const cv::Point left = end(middle + scan.step_rad / 2);
        if (beam.kind == BeamKind::Free) {
            cv::fillConvexPoly(tinted, std::vector<cv::Point>{origin, right, left}, green, cv::LINE_AA);
        } else {
            cv::line(tinted, origin, end(middle), orange, 1, cv::LINE_AA);
            cv::line(picture, left, right, vermilion, 2, cv::LINE_AA);
            cv::line(tinted, left, right, vermilion, 2, cv::LINE_AA);
        }
    }
    cv::addWeighted(picture, 0.7, tinted, 0.3, 0, picture);
}

void draw_points(cv::Mat& picture, const Projection& p, const MapPanelContent& content) {
    const Timeline& timeline = content.timeline;
    const Frame& frame = content.frame;
    const Pose2 T_robot_start = robot_start(frame);
    const auto draw = [&](const std::vector<MapPoint>& points, std::size_t from, std::size_t to) {
        for (const MapPoint& point : points) {
            if (point.index < from || point.index >= to) continue;
            const double age_s = frame.step.timestamp_s - timeline.rows[point.index].timestamp_s;
            if (age_s < 0.0 || age_s > content.memory_s) continue;
            cv::circle(picture, p.at(transform(T_robot_start, point.at_m)), 2, point.moving ? blue : orange,
                       cv::FILLED, cv::LINE_AA);
        }
    };
    const std::size_t current = std::min(timeline.current, timeline.rows.size());
    draw(timeline.points, 0, current);
    draw(timeline.earlier_points, current, timeline.rows.size());
}

void draw_newest(cv::Mat& picture, const Projection& p, const CycleResult& cycle,
                 const Pose2& T_robot_cycle) {
    for (const ObstaclePoint& point : cycle.obstacles) {
        const Vector2d at_m = point.position_m.head<2>();
        // The deviation is along the line of sight.
        const Vector2d along = at_m.normalized() * point.sigma_m;
        const cv::Scalar& colour = point.moving ? blue : vermilion;
        cv::line(picture, p.at(transform(T_robot_cycle, at_m - along)),
                 p.at(transform(T_robot_cycle, at_m + along)), colour, 1, cv::LINE_AA);
        cv::circle(picture, p.at(transform(T_robot_cycle, at_m)), 4, ink, cv::FILLED, cv::LINE_AA);
        cv::circle(picture, p.at(transform(T_robot_cycle, at_m)), 3, colour, cv::FILLED, cv::LINE_AA);
    }
}

void draw_contacts(cv::Mat& picture, const Projection& p, const ContactScan& scan) {
    for (const report::ContactSegment& contact : report::contact_segments(scan, Pose2{})) {
        const cv::Scalar colour = report::colour_of(contact.cause);
        cv::line(picture, p.at(contact.near_m), p.at(contact.far_m), colour, 1, cv::LINE_AA);
        cv::line(picture, p.at(contact.right_m), p.at(contact.left_m), ink, 5, cv::LINE_AA);
        cv::line(picture, p.at(contact.right_m), p.at(contact.left_m), colour, 3, cv::LINE_AA);
    }
}

/// Indices of the fields up to now whose poses are drawn as a path, thinned out for a long drive.
std::vector<std::size_t> fields_of_way(const MapPanelContent& content) {
    constexpr std::size_t most = 2000;
    const std::size_t count = std::min(content.frame.index, content.timeline.rows.size());
    std::vector<std::size_t> fields;
    for (std::size_t i = 0; i < count; i += 1 + count / most) fields.push_back(i);
    return fields;
}

void draw_way(cv::Mat& picture, const std::vector<cv::Point>& way, const cv::Scalar& colour, int width) {
    if (way.size() > 1) cv::polylines(picture, way, false, colour, width, cv::LINE_AA);
    if (!way.empty()) cv::circle(picture, way.back(), width / 2 + 2, colour, cv::FILLED, cv::LINE_AA);
}

/// Draws the path of another track up to now, moved to the start of the flow's path.
void draw_track(cv::Mat& picture, const Projection& p, const MapPanelContent& content,
                const evaluation::PoseTrack& track, const cv::Scalar& colour, int width) {
    if (track.empty() || content.timeline.rows.empty()) return;
    const auto first = track.ground_at(content.timeline.rows.front().timestamp_s);
    if (!first) return;
    const Pose2 T_robot_origin = compose(robot_start(content.frame), inverse(*first));
    std::vector<cv::Point> way;
    const auto add = [&](double timestamp_s) {
        const auto pose = track.ground_at(timestamp_s);
        if (pose) way.push_back(p.at(transform(T_robot_origin, {pose->x_m, pose->y_m})));
    };
    for (const std::size_t i : fields_of_way(content)) add(content.timeline.rows[i].timestamp_s);
    add(content.frame.step.timestamp_s);
    draw_way(picture, way, colour, width);
}

void draw_flow_way(cv::Mat& picture, const Projection& p, const MapPanelContent& content) {
    std::vector<cv::Point> way;
    const Pose2 T_robot_start = robot_start(content.frame);
    for (const std::size_t i : fields_of_way(content)) {
        const Pose2& pose = content.timeline.rows[i].T_start_robot;
        way.push_back(p.at(transform(T_robot_start, {pose.x_m, pose.y_m})));
    }
    way.push_back(p.robot_px);
    draw_way(picture, way, blue, 6);
}

void draw_robot(cv::Mat& picture, const Projection& p) {
    const std::vector<cv::Point> shape = {p.robot_px + cv::Point(0, -9), p.robot_px + cv::Point(6, 6),
                                          p.robot_px + cv::Point(-6, 6)};
    cv::fillConvexPoly(picture, shape, ink, cv::LINE_AA);
}

void draw_legend(cv::Mat& panel, const MapPanelContent& content, int top_px) {
    panel.rowRange(top_px, panel.rows).setTo(paper);
    LegendRow row(panel, {6, top_px + 2, panel.cols - 12, line_px});
    row.add("obstacles, with deviation", vermilion, LegendRow::Mark::Dot);
    row.add("earlier", orange, LegendRow::Mark::Dot);
    row.add("moving", blue, LegendRow::Mark::Dot);
    row.add("seen free", 0.3 * green + 0.7 * paper);
    row.add("scan", vermilion, LegendRow::Mark::Line);
    if (content.contacts) row.add("wall", report::colour_of(BeamCause::Wall), LegendRow::Mark::Line);
    if (content.contacts) row.add("drop", report::colour_of(BeamCause::Drop), LegendRow::Mark::Line);
    row.add("flow", blue, LegendRow::Mark::Line);
    if (!content.timeline.odometry.empty()) row.add("odometry", purple, LegendRow::Mark::Line);
    if (!content.timeline.ground_truth.empty()) row.add("truth", ink, LegendRow::Mark::Line);
}

}  // namespace

cv::Point map_px(const Eigen::Vector2d& robot_m, const cv::Size& size, double ahead_m) {
    return projection_of(size, ahead_m).at(robot_m);
}

cv::Mat map_panel(const MapPanelContent& content, const cv::Size& size) {
    cv::Mat panel(size, CV_8UC3, paper);
    const Projection p = projection_of(size, content.ahead_m);
    cv::Mat picture = panel.rowRange(0, p.size.height);
    draw_grid(picture, p);
    const CycleResult* cycle = content.frame.last_cycle.get();
    Pose2 T_robot_cycle;
    if (cycle != nullptr) {
        T_robot_cycle = compose(robot_start(content.frame), cycle->T_start_robot);
        draw_scan(picture, p, *cycle, T_robot_cycle);
    }
    draw_points(picture, p, content);
    // Each path is thinner than the one below it, so that all stay visible.
    draw_flow_way(picture, p, content);
    draw_track(picture, p, content, content.timeline.odometry, purple, 3);
    draw_track(picture, p, content, content.timeline.ground_truth, ink, 1);
    if (cycle != nullptr) draw_newest(picture, p, *cycle, T_robot_cycle);
    if (content.contacts) draw_contacts(picture, p, content.frame.contacts.scan());
    draw_robot(picture, p);
    draw_legend(panel, content, p.size.height);
    return panel;
}

}  // namespace flownav::view
