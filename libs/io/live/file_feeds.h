#pragma once
#include <mrpt/config/CConfigFileMemory.h>

#include <memory>
#include <string>

#include "field_feed.h"

namespace flownav::io {

/// Opens a video file; its images have the stamps of the container, or rate_hz. Throws InputError.
std::unique_ptr<FieldFeed> make_video_feed(const ProducerSettings& settings, const std::string& file);

/// Opens a folder of numbered images at rate_hz. Throws InputError, and ConfigError about the keys that
/// describe the folder.
std::unique_ptr<FieldFeed> make_folder_feed(const ProducerSettings& settings);

/// The keys of the camera as the section "camera" of an ini of MRPT.
mrpt::config::CConfigFileMemory camera_section(const ProducerSettings& settings);

/// The source and the number of images read, for messages.
std::string place_after(const std::string& source, std::uint64_t images);

}  // namespace flownav::io
