#pragma once
#include <opencv2/core/mat.hpp>

#include "field_panel.h"
#include "view_model.h"

namespace flownav::view {

/// What one sees that is no part of the drive.
struct Look {
    double ahead_m = 8.0;     ///< reach of the map
    bool predictions = true;  ///< draw predicted vectors
    std::string note;         ///< one line for the person: what was saved, what went wrong
};

/// With the map as far as points are reported.
Look look_for(const config::Config& config);

/// Where the panels lie in a picture.
struct ViewLayout {
    cv::Rect title, field, map, block, strip;
};

constexpr int least_width_px = 640;
constexpr int least_height_px = 480;

/// `wide`: for a field that is more than twice as wide as high.
ViewLayout layout_of(const cv::Size& size, bool wide = false);

/// The layout for the model's field.
ViewLayout layout_of(const ViewModel& model, const cv::Size& size);

/// All panels in one picture (8-bit BGR, `size`): what the window shows and what a screenshot holds.
cv::Mat view_picture(const ViewModel& model, const Look& look, const cv::Size& size);

/// The pixel of the shown field under a pixel of the picture; nothing beside it.
std::optional<Eigen::Vector2d> field_px_under(const ViewModel& model, const cv::Size& size,
                                              const cv::Point& at);

/// The pixel of the picture that shows a pixel of the field.
cv::Point picture_px_of(const ViewModel& model, const cv::Size& size, const Eigen::Vector2d& field_px);

}  // namespace flownav::view
