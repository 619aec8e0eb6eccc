#pragma once

#include <array>

#include "flownav/core/field_status.h"

namespace flownav {

/// What one field tells about the sensor itself: whether it sees, and how it thinks the robot moved. The
/// guard between navigator and motors reads it.
struct SensorReport {
    /// Columns of the image, from left to right, in which blocks are counted.
    static constexpr int sectors = 4;

    double timestamp_s = 0.0;  ///< of the field
    FieldStatus status = FieldStatus::Waiting;
    bool repeated = false;                 ///< the image is one of the last two once more, to the last pixel
    bool end_of_cycle = false;             ///< obstacles are new
    double omega_radps = 0.0;              ///< from the previous field to this one, > 0 left
    double v_mps = 0.0;                    ///< mean forward speed since the reference
    bool v_measured = false;               ///< false: predicted or carried over
    double carried_s = 0.0;                ///< for so long turn or speed were not measured, see Step
    std::array<int, sectors> blocks = {};  ///< of the layout, whether they could be matched or not
    std::array<int, sectors> confident = {};  ///< of these: matched unambiguously
};

}  // namespace flownav
