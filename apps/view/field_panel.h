#pragma once
#include <opencv2/core/mat.hpp>
#include <optional>

#include "flownav/flow/params.h"
#include "frame.h"

namespace flownav::view {

/// What of a field is drawn.
struct FieldPanelContent {
    const Frame& frame;
    flow::FlowParams flow;
    std::optional<std::size_t> hovered;  ///< block to point out
    bool predictions = true;
};

/// Where the field lies in its panel.
struct FieldPlace {
    cv::Rect area;        ///< of the picture of the field
    double zoom_x = 1.0;  ///< pixels of the panel for one of the field
    double zoom_y = 1.0;

    /// The pixel of the field under a pixel of the panel; nothing beside the field.
    std::optional<Eigen::Vector2d> field_px(const cv::Point& at) const;
    cv::Point panel_px(const Eigen::Vector2d& field_px) const;
};

/// The largest place for the field, in its true shape, above the legend.
FieldPlace field_place(const Field& field, const cv::Size& panel);

/// The field (8-bit BGR, `size`): blocks coloured by their label where they are now, vectors as arrows, what
/// the prediction expected as crosses, the ground window, the blind cone; with legend and counts below.
cv::Mat field_panel(const FieldPanelContent& content, const cv::Size& size);

}  // namespace flownav::view
