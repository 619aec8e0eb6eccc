#pragma once
#include <opencv2/core/mat.hpp>

#include "flownav/core/field.h"
#include "flownav/pipeline/step.h"
#include "flownav/report/field_drawing.h"

namespace flownav::report {

/// A picture for people (8-bit BGR): the field, stretched so that shapes look right although a PAL field has
/// half the lines; every measured block coloured by its label with its vector as an arrow that ends where the
/// block is now; the floor that the contact scan confirmed, and its contacts; below it a legend with counts
/// and the state of the step. `contacts` must be in the robot frame of the step. Colours stay apart for
/// colour-blind eyes.
cv::Mat annotated_field(const Field& field, const pipeline::Step& step, const ContactScan& contacts);

/// The same at a given scale, without legend.
cv::Mat marked_field(const Field& field, const pipeline::Step& step, const ContactScan& contacts,
                     const FieldScale& scale);

}  // namespace flownav::report
