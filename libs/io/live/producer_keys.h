#pragma once
#include <string>

#include "flownav/io/producer_settings.h"

namespace flownav::io {

/// Who reads a key of the section.
enum class KeyOwner {
    Grabber,   ///< CGenericSensor or rawlog-grabber
    Camera,    ///< CCameraSensor
    Producer,  ///< read_producer_settings()
    Flownav,   ///< section.key of the ini of flownav
    Nobody,
};

/// The key in any mixture of upper and lower case, as MRPT takes it.
KeyOwner owner_of(const std::string& key);

/// Sets one of the producer's own keys. Throws ConfigError.
void set_producer_value(ProducerSettings& settings, const std::string& key, const std::string& value);

/// The known key that `key` was most likely meant to be.
std::string nearest_producer_key(const std::string& key);

}  // namespace flownav::io
