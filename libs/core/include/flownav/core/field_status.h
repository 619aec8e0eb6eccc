#pragma once
#include <array>
#include <cstdint>

namespace flownav {

/// What the sensor can say about a field.
enum class FieldStatus {
    Ok,         ///< omega was measured with this field
    Waiting,    ///< first field, or first after a gap: a reference, nothing to compare it with
    Lost,       ///< vectors there were, but no common motion explains them
    NoTexture,  ///< too few unambiguous vectors
    BadField,   ///< cannot be used at all, see FieldFault; the held reference stays
};

constexpr std::array<FieldStatus, 5> all_field_statuses = {
    FieldStatus::Ok, FieldStatus::Waiting, FieldStatus::Lost, FieldStatus::NoTexture, FieldStatus::BadField};

/// The word of a status, as egomotion.csv has it.
const char* to_string(FieldStatus status);

/// Why a field is a BadField.
enum class FieldFault {
    None,
    NoPicture,      ///< black, saturated, constant or empty
    WrongSize,      ///< the image is not as large as its camera says, or its rows overlap
    BadCamera,      ///< a focal length that is not > 0, or a number that is not finite
    TimeNotRising,  ///< not later than the field before it, or not a time at all
};

constexpr std::array<FieldFault, 5> all_field_faults = {FieldFault::None, FieldFault::NoPicture,
                                                        FieldFault::WrongSize, FieldFault::BadCamera,
                                                        FieldFault::TimeNotRising};

/// The word of a fault, as summary.json has it.
const char* to_string(FieldFault fault);

/// How many fields had each fault, in the order of FieldFault.
using FieldFaultCounts = std::array<std::uint64_t, all_field_faults.size()>;

}  // namespace flownav
