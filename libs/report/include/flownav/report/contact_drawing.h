#pragma once
#include <opencv2/core/mat.hpp>

#include "flownav/core/contact_scan.h"
#include "flownav/report/field_drawing.h"

namespace flownav::report {

/// Tints the floor that a contact scan confirmed in the picture of a field of `camera`. The scan must be in
/// the robot frame of the field. Draws nothing behind a closed gate.
void tint_free_floor(cv::Mat& picture, const ContactScan& scan, const CameraModel& camera,
                     const FieldScale& scale);

/// Draws each contact of the scan as a line on the floor, as wide as its strip, in the colour of its cause,
/// with a thin line over its interval. The same conditions hold.
void draw_contacts(cv::Mat& picture, const ContactScan& scan, const CameraModel& camera,
                   const FieldScale& scale);

}  // namespace flownav::report
