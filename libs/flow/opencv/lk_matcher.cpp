#include "flownav/flow/lk_matcher.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/video/tracking.hpp>

#include "flownav/flow/block_bounds.h"
#include "flownav/flow/match_blocks.h"
#include "flownav/flow/matcher_registry.h"

namespace flownav::flow {
namespace {

using Points = std::vector<cv::Point2f>;
using Pyramid = std::vector<cv::Mat>;  // image, its derivatives, half the image, its derivatives, ...

constexpr int iterations_max = 30;
constexpr double step_min_px = 0.01;

// Constants of sigma_of().
constexpr double derivative_gain = 4 * 32.0;  // of the sum of four of OpenCV's Scharr filters
constexpr double noise_slope2 = 0.2;          // squared slope per pixel caused by noise, in squared residuals
constexpr double true_share_min = 0.2;        // smallest share of the slopes that counts as texture
constexpr double sigma_floor_px = 0.03;

/// New positions of points, and their residuals there.
struct Tracks {
    Points to;
    std::vector<std::uint8_t> found;
    std::vector<float> residual;  ///< mean absolute difference over the window, grey levels
};

struct RoundTrip {
    Tracks there, back;
};

/// cv::Mat has no const view; the result must only be read.
cv::Mat view_of(const ImageView& image) {
    return {image.height_px, image.width_px, CV_8UC1, const_cast<std::uint8_t*>(image.data),
            static_cast<std::size_t>(image.stride_bytes)};
}

cv::Point2f to_cv(const Eigen::Vector2d& point) {
    return cv::Point2d(point.x(), point.y());
}

/// Returns the reference adapted to the brightness of the newer image, as the block matcher does it.
cv::Mat compensated(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                    const std::vector<Eigen::Vector2i>& bias_px) {
    GreySums sums;
    GreyTable greys = grey_table(compare_brightness(reference, newer, layout, bias_px, sums));
    cv::Mat image;
    cv::LUT(view_of(reference), cv::Mat(1, static_cast<int>(greys.size()), CV_8UC1, greys.data()), image);
    return image;
}

Pyramid pyramid_of(const cv::Mat& image, const LkSettings& settings) {
    Pyramid pyramid;
    cv::buildOpticalFlowPyramid(image, pyramid, {settings.window_px, settings.window_px}, settings.levels);
    return pyramid;
}

Tracks track(const Pyramid& from, const Pyramid& to, const Points& points, Points expected,
             const LkSettings& settings) {
    Tracks tracks;
    tracks.to = std::move(expected);
    const cv::TermCriteria stop(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, iterations_max, step_min_px);
    cv::calcOpticalFlowPyrLK(from, to, points, tracks.to, tracks.found, tracks.residual,
                             {settings.window_px, settings.window_px}, settings.levels, stop,
                             cv::OPTFLOW_USE_INITIAL_FLOW, settings.eigenvalue_min);
    return tracks;
}

/// Returns the pixels of the window about a point, clipped to the image; the point lies between four pixels.
cv::Rect window_about(const Eigen::Vector2d& centre_px, const cv::Mat& image, int window_px) {
    const Eigen::Vector2i corner = (centre_px.array() - window_px / 2.0).round().cast<int>();
    return cv::Rect(corner.x(), corner.y(), window_px + 1, window_px + 1) & cv::Rect({}, image.size());
}

/// Structure tensor of a window: sum of the outer products of the slopes half-way between its pixels, in
/// squared grey levels per squared pixel.
Eigen::Matrix2d slopes2_of(const cv::Mat& derivatives, const cv::Rect& window) {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (int v = window.y; v < window.br().y - 1; ++v) {
        const auto* row = derivatives.ptr<cv::Vec2s>(v);
        const auto* next = derivatives.ptr<cv::Vec2s>(v + 1);
        for (int u = window.x; u < window.br().x - 1; ++u) {
            const Eigen::Vector2d slope(row[u][0] + row[u + 1][0] + next[u][0] + next[u + 1][0],
                                        row[u][1] + row[u + 1][1] + next[u][1] + next[u + 1][1]);
            sum += slope * slope.transpose();
        }
    }
    return sum / (derivative_gain * derivative_gain);
}

/// Standard deviation of a least squares fit in u and v, in px: the noise of the grey levels, estimated from
/// the residual, over the slopes, from which the noise's own slopes are subtracted. Compared with exact flow
/// it holds within a third from 0.05 to 0.4 px on even textures and is too large above; in windows with only
/// one edge off the centre, errors are 2 to 3 times larger.
Eigen::Vector2d sigma_of(const Eigen::Matrix2d& slopes2, double residual, int pixels) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
    axes.computeDirect(slopes2);
    const Eigen::Array2d observed = axes.eigenvalues().array().max(1.0);
    const double noise = noise_slope2 * residual * residual * pixels;
    const Eigen::Array2d true_part = (observed - noise).max(true_share_min * observed);
    const Eigen::Vector2d variances = observed / true_part.square();
    const Eigen::Matrix2d turn2 = axes.eigenvectors().cwiseAbs2();
    return sigma_floor_px + residual * (turn2 * variances).array().sqrt();
}

bool has_window(const Eigen::Vector2i& corner_px, const Eigen::Vector2i& bias_px, const ImageView& image) {
    return !clipped_range(corner_px, bias_px, image).empty();
}

bool is_inside(const Eigen::Vector2d& corner_px, const ImageView& image) {
    return corner_px.minCoeff() >= 0 && corner_px.x() <= image.width_px - block_px &&
           corner_px.y() <= image.height_px - block_px;
}

/// Tracks points forward from their expected displacements, and back from the opposite ones.
RoundTrip follow(const Pyramid& from, const Pyramid& to, const Points& at, const Points& displacements,
                 const LkSettings& settings) {
    Points expected(at.size());
    for (std::size_t i = 0; i < at.size(); ++i) expected[i] = at[i] + displacements[i];
    RoundTrip trip;
    trip.there = track(from, to, at, expected, settings);
    for (std::size_t i = 0; i < at.size(); ++i) expected[i] = trip.there.to[i] - displacements[i];
    trip.back = track(to, from, trip.there.to, expected, settings);
    return trip;
}

/// Returns the vector of point i of a round trip; its confidence is 0 when a track was lost.
FlowVector vector_of(const RoundTrip& trip, std::size_t i, const Eigen::Vector2d& at_px,
                     const Pyramid& reference, const LkSettings& settings) {
    FlowVector vector;
    vector.at_px = at_px;
    vector.flow_px = Eigen::Vector2d(trip.there.to[i].x, trip.there.to[i].y) - at_px;
    if (trip.there.found[i] == 0 || trip.back.found[i] == 0) return vector;
    const cv::Rect window = window_about(at_px, reference[0], settings.window_px);
    vector.sigma_px = sigma_of(slopes2_of(reference[1], window), trip.there.residual[i], window.area());
    const double disagreement_px = cv::norm(trip.back.to[i] - to_cv(at_px));
    vector.confidence = std::max(0.0, 1.0 - disagreement_px / settings.disagreement_max_px);
    return vector;
}

}  // namespace

void LkMatcher::operator()(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                           const std::vector<Eigen::Vector2d>& predicted_px,
                           std::vector<FlowVector>& vectors) const {
    const std::size_t n = layout.size();
    vectors.assign(n, {});
    if (n == 0) return;
    std::vector<Eigen::Vector2i> bias_px(n);
    Points at(n), displacements(n);
    for (std::size_t i = 0; i < n; ++i) {
        bias_px[i] = whole_px(predicted_px[i]);
        at[i] = to_cv(layout.centre_px[i]);
        displacements[i] = to_cv(predicted_px[i]);
    }
    const bool compensate = settings_.brightness == BrightnessModel::Image;
    const Pyramid from = pyramid_of(
        compensate ? compensated(reference, newer, layout, bias_px) : view_of(reference), settings_);
    const RoundTrip trip = follow(from, pyramid_of(view_of(newer), settings_), at, displacements, settings_);
    for (std::size_t i = 0; i < n; ++i) {
        vectors[i] = vector_of(trip, i, layout.centre_px[i], from, settings_);
        vectors[i].valid = has_window(layout.corner_px[i], bias_px[i], newer) &&
                           is_inside(layout.corner_px[i].cast<double>() + vectors[i].flow_px, newer);
    }
}

void register_lk_matcher() {
    static const bool registered = [] {
        register_matcher("lk", [](const FlowParams& params, int) {
            LkSettings settings;
            settings.brightness = params.brightness;
            return LkMatcher(settings);
        });
        return true;
    }();
    static_cast<void>(registered);
}

}  // namespace flownav::flow
