#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace flownav::regress {

/// SHA-256 as 64 lower-case hexadecimal digits.
std::string sha256_of_text(std::string_view text);

/// SHA-256 of a file's content. Throws std::system_error when it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

/// True for 64 lower-case hexadecimal digits.
bool is_sha256(std::string_view text);

}  // namespace flownav::regress
