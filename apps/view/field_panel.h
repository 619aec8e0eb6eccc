#pragma once
#include <opencv2/core/mat.hpp>
#include <optional>

#include "flownav/flow/params.h"
#include "frame.h"

namespace flownav::view {

/// Contents of the field panel.
struct FieldPanelContent {
    const Frame& frame;
    flow::FlowParams flow;
    std::optional<std::size_t> hovered;  ///< index of the highlighted block
    bool predictions = true;
    bool contacts = true;  ///< draws the contact scan
};

/// Position of the field in its panel.
struct FieldPlace {
    cv::Rect area;        ///< of the picture of the field
    double zoom_x = 1.0;  ///< panel pixels per field pixel
    double zoom_y = 1.0;

    /// Converts a panel pixel to a field pixel; empty beside the field.
    std::optional<Eigen::Vector2d> field_px(const cv::Point& at) const;
    cv::Point panel_px(const Eigen::Vector2d& field_px) const;
};

/// The largest place for the field above the legend, keeping its aspect ratio.
FieldPlace field_place(const Field& field, const cv::Size& panel);

/// Draws the field (8-bit BGR, `size`): blocks coloured by label at their current place, vectors as arrows,
/// predictions as crosses, the contact scan, the ground window, the focus exclusion; with legend and counts
/// below.
cv::Mat field_panel(const FieldPanelContent& content, const cv::Size& size);

}  // namespace flownav::view
