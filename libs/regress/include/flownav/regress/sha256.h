#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace flownav::regress {

/// SHA-256 as 64 lower-case hexadecimal digits.
std::string sha256_of_text(std::string_view text);

/// The same of a file's content. Throws std::system_error when it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

/// Whether `text` looks like one.
bool is_sha256(std::string_view text);

}  // namespace flownav::regress
