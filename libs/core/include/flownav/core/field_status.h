#pragma once
#include <array>
#include <cstdint>

namespace flownav {

/// Outcome of one field.
enum class FieldStatus {
    Ok,         ///< omega was measured with this field
    Waiting,    ///< first field, or first after a gap: it becomes the reference, no motion is measured
    Lost,       ///< the vectors agree on no common motion
    NoTexture,  ///< too few unambiguous vectors
    BadField,   ///< the field is unusable, see FieldFault; the reference is kept
};

constexpr std::array<FieldStatus, 5> all_field_statuses = {
    FieldStatus::Ok, FieldStatus::Waiting, FieldStatus::Lost, FieldStatus::NoTexture, FieldStatus::BadField};

/// Name of a status, as written to egomotion.csv.
const char* to_string(FieldStatus status);

/// Reason of FieldStatus::BadField.
enum class FieldFault {
    None,
    NoPicture,      ///< black, saturated, constant or empty
    WrongSize,      ///< the image size differs from the camera's, or image rows overlap
    BadCamera,      ///< a focal length is not > 0, or a parameter is not finite
    TimeNotRising,  ///< the time is not later than the previous field's, or not finite
};

constexpr std::array<FieldFault, 5> all_field_faults = {FieldFault::None, FieldFault::NoPicture,
                                                        FieldFault::WrongSize, FieldFault::BadCamera,
                                                        FieldFault::TimeNotRising};

/// Name of a fault, as written to summary.json.
const char* to_string(FieldFault fault);

/// Number of fields with each fault, in the order of FieldFault.
using FieldFaultCounts = std::array<std::uint64_t, all_field_faults.size()>;

}  // namespace flownav
