#pragma once
#include <string>

#include "flownav/io/producer_settings.h"

namespace flownav::io {

/// Reader of a key of the section.
enum class KeyOwner {
    Grabber,   ///< read by CGenericSensor or rawlog-grabber
    Camera,    ///< read by CCameraSensor
    Producer,  ///< read by read_producer_settings()
    Flownav,   ///< section.key of a flownav ini
    Nobody,
};

/// Returns the reader of a key; ignores upper and lower case, as MRPT does.
KeyOwner owner_of(const std::string& key);

/// Sets one of the producer's own keys. Throws ConfigError when the value is unparsable or out of range.
void set_producer_value(ProducerSettings& settings, const std::string& key, const std::string& value);

/// Returns the known key that is nearest to a misspelt one.
std::string nearest_producer_key(const std::string& key);

}  // namespace flownav::io
