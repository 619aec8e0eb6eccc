#pragma once
#include <opencv2/core/mat.hpp>

#include "field_panel.h"
#include "view_model.h"

namespace flownav::view {

/// Display settings, independent of the drive.
struct Look {
    double ahead_m = 8.0;     ///< reach of the map
    bool predictions = true;  ///< draws predicted vectors
    bool contacts = true;     ///< draws the contact scan
    std::string note;         ///< one line for the user: saved file or error
};

/// Returns a look whose map reaches as far as obstacle points do.
Look look_for(const config::Config& config);

/// Positions of the panels in a picture.
struct ViewLayout {
    cv::Rect title, field, map, block, strip;
};

constexpr int least_width_px = 640;
constexpr int least_height_px = 480;

/// `wide`: for a field that is more than twice as wide as high.
ViewLayout layout_of(const cv::Size& size, bool wide = false);

/// The layout for the model's field.
ViewLayout layout_of(const ViewModel& model, const cv::Size& size);

/// Draws all panels in one picture (8-bit BGR, `size`), for the window and for screenshots.
cv::Mat view_picture(const ViewModel& model, const Look& look, const cv::Size& size);

/// Converts a pixel of the picture to a pixel of the shown field; empty beside it.
std::optional<Eigen::Vector2d> field_px_under(const ViewModel& model, const cv::Size& size,
                                              const cv::Point& at);

/// Converts a pixel of the field to a pixel of the picture.
cv::Point picture_px_of(const ViewModel& model, const cv::Size& size, const Eigen::Vector2d& field_px);

}  // namespace flownav::view
