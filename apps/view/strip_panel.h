#pragma once
#include <opencv2/core/mat.hpp>
#include <optional>
#include <utility>

#include "flownav/core/field_status.h"
#include "timeline.h"

namespace flownav::view {

struct StripPanelContent {
    const Timeline& timeline;
    std::size_t index = 0;                                       ///< of the field shown
    std::optional<std::pair<std::size_t, std::size_t>> stretch;  ///< marked for export
};

/// Colour of a status in the band.
cv::Scalar status_colour(FieldStatus status);

/// Column of a time, in seconds from the start, in a panel of this width; and the inverse.
int strip_column(const Timeline& timeline, double time_s, int width_px);
double strip_time_s(const Timeline& timeline, int column, int width_px);

/// The drive over time (8-bit BGR, `size`): turn rate, speed, obstacle points of each cycle, and a band of
/// the status, the worst of the fields that share a column; the field shown is marked. What was computed
/// with earlier parameters is pale.
cv::Mat strip_panel(const StripPanelContent& content, const cv::Size& size);

}  // namespace flownav::view
