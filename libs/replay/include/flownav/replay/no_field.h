#pragma once
#include <filesystem>
#include <string>

#include "flownav/sensor/config.h"
#include "flownav/sensor/event_maker.h"

namespace flownav {

/// Why a rawlog that was read to its clean end gave no field, and what to do.
std::string no_field_message(const std::filesystem::path& input, const InputCounts& read,
                             const CameraConfig& camera);

}  // namespace flownav
