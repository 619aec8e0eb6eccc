#pragma once

#include <array>

#include "flownav/core/field_status.h"

namespace flownav {

/// State of the sensor at one field: whether it sees, and which motion of the robot it measured. Input of the
/// guard between navigator and motors.
struct SensorReport {
    /// Number of vertical image strips, from left to right, in which blocks are counted.
    static constexpr int sectors = 4;

    double timestamp_s = 0.0;  ///< time of the field, seconds since the epoch
    FieldStatus status = FieldStatus::Waiting;
    bool repeated = false;      ///< the image equals one of the last two in every pixel
    bool end_of_cycle = false;  ///< this field closes a cycle: its obstacles are new
    double omega_radps = 0.0;   ///< from the previous field to this one, > 0 left
    double v_mps = 0.0;         ///< mean forward speed since the reference
    bool v_measured = false;    ///< false: predicted or carried over
    double carried_s = 0.0;     ///< time since turn and speed were last both measured; 0: with this field
    std::array<int, sectors> blocks = {};     ///< blocks per strip, matched or not
    std::array<int, sectors> confident = {};  ///< blocks per strip that were matched unambiguously
    std::array<bool, sectors> unlit = {};     ///< the strip is black or saturated: a lens that is covered
    bool scans = false;                       ///< contact scans show what has no texture
    bool sees_edges = false;  ///< the last scan saw an edge in some strip, and its floor was believed
};

}  // namespace flownav
