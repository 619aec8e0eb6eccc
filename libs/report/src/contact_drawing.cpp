#include "flownav/report/contact_drawing.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "flownav/core/plane_geometry.h"
#include "flownav/report/cause_style.h"
#include "flownav/report/contact_segments.h"

namespace flownav::report {

namespace {

constexpr double tint_share = 0.25;
const cv::Scalar rim(25, 25, 25);

/// From the floor in the robot frame to the picture of a field.
class FloorView {
  public:
    FloorView(const CameraModel& camera, const FieldScale& scale)
        : mapper_(camera), plane_(camera.mount), scale_(scale) {
        for (const double u : {0.0, 0.5, 1.0})
            for (const double v : {0.0, 0.5, 1.0}) include({u * camera.width_px, v * camera.height_px});
    }

    /// Pixel of the picture; empty for floor that is far outside the view, where a lens model is not valid.
    std::optional<cv::Point> at(const Eigen::Vector2d& robot_m) const {
        const CameraMount& mount = mapper_.camera().mount;
        const auto ray = plane_.floor_at(robot_m.x() - mount.forward_m, mount.left_m - robot_m.y());
        if (!ray || !is_near_view(*ray)) return std::nullopt;
        return scale_.at(mapper_.pixel(*ray));
    }

  private:
    void include(const Eigen::Vector2d& pixel) {
        const Eigen::Vector2d ray = mapper_.ray(pixel);
        low_ = low_.cwiseMin(ray);
        high_ = high_.cwiseMax(ray);
    }

    bool is_near_view(const Eigen::Vector2d& ray) const {
        constexpr double beyond_share = 0.25;  // of the view, on every side
        const Eigen::Vector2d margin = beyond_share * (high_ - low_);
        return (ray.array() > (low_ - margin).array()).all() &&
               (ray.array() < (high_ + margin).array()).all();
    }

    RayMapper mapper_;
    PlaneGeometry plane_;
    FieldScale scale_;
    Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
    Eigen::Vector2d high_ = Eigen::Vector2d::Zero();
};

/// Pixels of the floor along the tangent `right`, from `free_m` towards the camera until it leaves the view.
std::vector<cv::Point> edge_of_strip(const FloorView& view, const ContactScan& scan, double right,
                                     double free_m) {
    constexpr double ratio = 0.92;  // of the distances of neighbouring points
    constexpr double nearest_m = 0.05;
    constexpr double farthest_m = 1000.0;
    std::vector<cv::Point> edge;
    for (double forward_m = std::min(free_m, farthest_m); forward_m > nearest_m; forward_m *= ratio) {
        const auto pixel = view.at(point_of(scan, right, forward_m));
        if (pixel) edge.push_back(*pixel);
        if (!pixel && !edge.empty()) break;
    }
    return edge;
}

void draw_rimmed(cv::Mat& picture, const cv::Point& from, const cv::Point& to, const cv::Scalar& colour,
                 int width_px) {
    cv::line(picture, from, to, rim, width_px + 2, cv::LINE_AA);
    cv::line(picture, from, to, colour, width_px, cv::LINE_AA);
}

}  // namespace

void tint_free_floor(cv::Mat& picture, const ContactScan& scan, const CameraModel& camera,
                     const FieldScale& scale) {
    if (scan.gate != ContactGate::Open) return;
    const FloorView view(camera, scale);
    cv::Mat tinted = picture.clone();
    for (std::size_t i = 0; i < scan.strips.size(); ++i) {
        const double middle = middle_tangent(scan, static_cast<int>(i));
        const double free_m = scan.strips[i].free_m;
        std::vector<cv::Point> outline = edge_of_strip(view, scan, middle - scan.step / 2, free_m);
        const std::vector<cv::Point> right = edge_of_strip(view, scan, middle + scan.step / 2, free_m);
        outline.insert(outline.end(), right.rbegin(), right.rend());
        if (outline.size() > 2)
            cv::fillPoly(tinted, std::vector<std::vector<cv::Point>>{outline}, confirmed_floor);
    }
    cv::addWeighted(picture, 1 - tint_share, tinted, tint_share, 0, picture);
}

void draw_contacts(cv::Mat& picture, const ContactScan& scan, const CameraModel& camera,
                   const FieldScale& scale) {
    const FloorView view(camera, scale);
    for (const ContactSegment& segment : contact_segments(scan, Pose2{})) {
        const auto near = view.at(segment.near_m);
        const auto far = view.at(segment.far_m);
        if (near && far) draw_rimmed(picture, *near, *far, colour_of(segment.cause), 1);
    }
    for (const ContactSegment& segment : contact_segments(scan, Pose2{})) {
        const auto left = view.at(segment.left_m);
        const auto right = view.at(segment.right_m);
        if (left && right) draw_rimmed(picture, *left, *right, colour_of(segment.cause), 3);
    }
}

}  // namespace flownav::report
