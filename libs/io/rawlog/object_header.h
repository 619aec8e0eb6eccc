#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace flownav::io {

/// The beginning of a serialized MRPT object.
struct ObjectHeader {
    enum class Kind { Good, TooShort, Malformed };
    Kind kind = Kind::Malformed;
    std::string class_name;
};

/// True when `name` can be the name of a C++ class.
bool is_class_name(const std::string& name);

/// Largest size of a header in bytes.
constexpr std::size_t object_header_bytes = 4 + 127;

/// Parses the class name from the first bytes of an object: length | 0x80 and the name, or, before MRPT
/// 0.5.5, a 32-bit length and the name.
ObjectHeader parse_object_header(const std::vector<std::uint8_t>& bytes);

}  // namespace flownav::io
