#include "flownav/report/residual_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "flownav/cli/number_text.h"
#include "flownav/core/plane_geometry.h"
#include "flownav/report/palette.h"

namespace flownav::report {
namespace {

using Eigen::Vector2d;

constexpr int columns = 16;
constexpr int rows = 12;
constexpr std::size_t cell_vectors_min = 5;
constexpr double floor_deviations = 4.685;
constexpr int picture_width_px = 640;
constexpr int title_px = 34;
constexpr double arrow_longest_px = 46.0;
constexpr Colour before_colour = palette::orange;
constexpr Colour after_colour = palette::sky_blue;

using Cells = std::array<std::array<std::vector<double>, 2>, std::size_t{columns} * rows>;

std::size_t cell_of(const Vector2d& at_px, const CameraModel& camera) {
    const auto index = [](double at, int size, int count) {
        return static_cast<std::size_t>(std::clamp(static_cast<int>(at / size * count), 0, count - 1));
    };
    return index(at_px.y(), camera.height_px, rows) * columns + index(at_px.x(), camera.width_px, columns);
}

/// Where the ground would put a vector's end, in pixels.
Vector2d predicted_end_px(const evaluation::SeenPair& s, const motion::PairFit& fit, const Vector2d& at_px) {
    return s.newer.pixel((fit.H_newer_reference * s.reference.ray(at_px).homogeneous()).hnormalized());
}

double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

ResidualField field_of(Cells& cells, const CameraModel& camera) {
    ResidualField field;
    std::vector<double> lengths;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i][0].size() < cell_vectors_min) continue;
        const std::size_t row = i / columns;
        const Vector2d at_px((static_cast<double>(i % columns) + 0.5) * camera.width_px / columns,
                             (static_cast<double>(row) + 0.5) * camera.height_px / rows);
        field.cells.push_back({at_px, {median(cells[i][0]), median(cells[i][1])}});
        lengths.push_back(field.cells.back().residual_px.norm());
    }
    if (!lengths.empty()) field.median_px = median(lengths);
    return field;
}

void enter(Cells& cells, std::size_t cell, const Vector2d& residual_px) {
    cells[cell][0].push_back(residual_px.x());
    cells[cell][1].push_back(residual_px.y());
}

/// One picture, with arrows `scale` times as long as the residuals.
cv::Mat panel(const cv::Mat& background, const CameraModel& camera, const ResidualField& field, double scale,
              const cv::Scalar& colour, const std::string& title) {
    cv::Mat picture;
    cv::copyMakeBorder(background, picture, title_px, 0, 0, 0, cv::BORDER_CONSTANT, cv::Scalar(24, 24, 24));
    const double sx = static_cast<double>(background.cols) / camera.width_px;
    const double sy = static_cast<double>(background.rows) / camera.height_px;
    const auto point = [&](const Vector2d& at_px) {
        return cv::Point(cv::saturate_cast<int>(at_px.x() * sx),
                         cv::saturate_cast<int>(at_px.y() * sy + title_px));
    };
    for (const auto& cell : field.cells) {
        cv::circle(picture, point(cell.at_px), 2, colour, cv::FILLED, cv::LINE_AA);
        cv::line(picture, point(cell.at_px), point(cell.at_px + scale * cell.residual_px), colour, 2,
                 cv::LINE_AA);
    }
    cv::putText(picture, title, {8, 22}, cv::FONT_HERSHEY_SIMPLEX, 0.5, cv::Scalar(235, 235, 235), 1,
                cv::LINE_AA);
    return picture;
}

cv::Mat dimmed(const Field& field) {
    const cv::Mat grey(field.image.height_px, field.image.width_px, CV_8UC1,
                       const_cast<std::uint8_t*>(field.image.data),  // OpenCV has no view of const pixels
                       static_cast<std::size_t>(field.image.stride_bytes));
    const CameraModel& c = field.camera;
    const double height = picture_width_px * (c.height_px / c.fy_px) / (c.width_px / c.fx_px);
    cv::Mat picture, bgr;
    cv::resize(grey, picture, {picture_width_px, std::max(64, cv::saturate_cast<int>(height))}, 0, 0,
               cv::INTER_LINEAR);
    picture.convertTo(picture, -1, 0.35);
    cv::cvtColor(picture, bgr, cv::COLOR_GRAY2BGR);
    return bgr;
}

double longest(const ResidualField& field) {
    double length = 0.0;
    for (const auto& cell : field.cells) length = std::max(length, cell.residual_px.norm());
    return length;
}

}  // namespace

ResidualComparison compare_residuals(const std::vector<evaluation::CalibrationPair>& pairs,
                                     const motion::MountAngles& before_rad,
                                     const motion::MountAngles& after_rad) {
    if (pairs.empty()) return {};
    Cells before, after;
    motion::PoseScratch scratch;
    for (const evaluation::CalibrationPair& pair : pairs) {
        const evaluation::SeenPair first = evaluation::seen(pair, before_rad);
        const evaluation::SeenPair second = evaluation::seen(pair, after_rad);
        const motion::PairFit a =
            motion::fit_pair(first.rays, first.camera, pair.motion, Geometry::MidPoint, {}, scratch);
        const motion::PairFit b =
            motion::fit_pair(second.rays, second.camera, pair.motion, Geometry::MidPoint, {}, scratch);
        if (a.ground_vectors == 0 || b.ground_vectors == 0) continue;
        const double below_min = motion::near_below_horizon(second.camera);
        const PlaneGeometry plane(second.camera.mount);
        for (std::size_t i = 0; i < pair.vectors.size(); ++i) {
            const FlowVector& v = pair.vectors[i];
            const Vector2d end_px = v.at_px + v.flow_px;
            const Vector2d residual_px = end_px - predicted_end_px(second, b, v.at_px);
            const bool floor =
                plane.below_horizon(second.rays[i].at) >= below_min &&
                residual_px.cwiseQuotient(v.sigma_px).norm() < floor_deviations * b.noise_factor;
            if (!floor) continue;
            const std::size_t cell = cell_of(v.at_px, pair.reference);
            enter(after, cell, residual_px);
            enter(before, cell, end_px - predicted_end_px(first, a, v.at_px));
        }
    }
    return {field_of(before, pairs.front().reference), field_of(after, pairs.front().reference)};
}

cv::Mat residual_picture(const Field& background, const ResidualComparison& residuals,
                         const std::string& before_title, const std::string& after_title) {
    const cv::Mat ground = dimmed(background);
    const double sx = static_cast<double>(ground.cols) / background.camera.width_px;
    const double most_px = std::max({longest(residuals.before), longest(residuals.after), 0.05});
    // A round magnification that keeps the longest arrow in its surroundings.
    const double scale = std::max(1.0, std::floor(arrow_longest_px / sx / most_px));
    const auto title = [](const std::string& text, const ResidualField& field) {
        return text + ", residual " + cli::fixed_text(field.median_px, 3) + " px";
    };
    cv::Mat both;
    cv::hconcat(panel(ground, background.camera, residuals.before, scale, before_colour,
                      title(before_title, residuals.before)),
                panel(ground, background.camera, residuals.after, scale, after_colour,
                      title(after_title, residuals.after)),
                both);
    cv::Mat picture;
    cv::copyMakeBorder(both, picture, 0, title_px, 0, 0, cv::BORDER_CONSTANT, cv::Scalar(24, 24, 24));
    cv::putText(picture,
                "Mean disagreement of the floor's vectors with the ground plane, drawn " +
                    cli::fixed_text(scale, 0) + " times as long",
                {8, picture.rows - 12}, cv::FONT_HERSHEY_SIMPLEX, 0.5, cv::Scalar(235, 235, 235), 1,
                cv::LINE_AA);
    return picture;
}

}  // namespace flownav::report
