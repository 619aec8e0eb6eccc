#pragma once
#include <opencv2/core/mat.hpp>
#include <optional>
#include <utility>

#include "timeline.h"

namespace flownav::view {

struct StripPanelContent {
    const Timeline& timeline;
    std::size_t index = 0;                                       ///< index of the field shown
    std::optional<std::pair<std::size_t, std::size_t>> stretch;  ///< marked for export
};

/// Column of a time, in seconds from the start, in a panel of this width; and the inverse.
int strip_column(const Timeline& timeline, double time_s, int width_px);
double strip_time_s(const Timeline& timeline, int column, int width_px);

/// Draws the drive over time (8-bit BGR, `size`): turn rate, speed, obstacle points of each cycle, and a band
/// of the status, the worst of the fields that share a column. The shown field is marked; results of earlier
/// parameters are pale.
cv::Mat strip_panel(const StripPanelContent& content, const cv::Size& size);

}  // namespace flownav::view
