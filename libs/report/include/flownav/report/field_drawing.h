#pragma once
#include <opencv2/core/mat.hpp>

#include "flownav/core/field.h"
#include "flownav/pipeline/step.h"
#include "flownav/report/label_style.h"

namespace flownav::report {

/// From pixels of a field to pixels of its picture.
struct FieldScale {
    double x = 1.0;
    double y = 1.0;

    /// OpenCV resizes about pixel corners.
    cv::Point at(const Eigen::Vector2d& pixel) const {
        return {cvRound((pixel.x() + 0.5) * x - 0.5), cvRound((pixel.y() + 0.5) * y - 0.5)};
    }
};

/// The field's camera with the pitch that was learnt on the way.
CameraModel camera_in_use(const Field& field, const pipeline::Step& step);

/// How much taller than wide a pixel of the field must be drawn for shapes to look right, 0.5..2: about 2 for
/// a field of half the lines.
double pixel_aspect(const Field& field);

/// The field as an 8-bit BGR picture, scaled.
cv::Mat scaled_field(const Field& field, const FieldScale& scale);

/// True when the record has something to show for a block of this label.
bool is_drawn(const pipeline::BlockRecord& block, BlockLabel label);

/// Tints every block of the style's label where it is now; obstacles, movers and candidates get a frame.
void tint_blocks(cv::Mat& picture, const pipeline::Step& step, const FieldScale& scale,
                 const LabelStyle& style);

/// Draws the vectors of every block of the style's label as arrows with a dark rim, which shows on light and
/// dark ground; ambiguous blocks as dots.
void draw_vectors(cv::Mat& picture, const pipeline::Step& step, const FieldScale& scale,
                  const LabelStyle& style);

}  // namespace flownav::report
