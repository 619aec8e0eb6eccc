#pragma once
#include <array>

namespace flownav {

/// What the sensor can say about a field.
enum class FieldStatus {
    Ok,         ///< omega was measured with this field
    Waiting,    ///< first field, or first after a gap: a reference, nothing to compare it with
    Lost,       ///< vectors there were, but no common motion explains them
    NoTexture,  ///< too few unambiguous vectors
    BadField,   ///< black, saturated or constant: not a picture
};

constexpr std::array<FieldStatus, 5> all_field_statuses = {
    FieldStatus::Ok, FieldStatus::Waiting, FieldStatus::Lost, FieldStatus::NoTexture, FieldStatus::BadField};

/// The word of a status, as egomotion.csv has it.
const char* to_string(FieldStatus status);

}  // namespace flownav
