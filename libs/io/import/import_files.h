#pragma once
#include <filesystem>
#include <string>
#include <vector>

/// Shared by the importers: pictures and the small text files of data sets. The functions throw InputError
/// naming the file unless documented otherwise.
namespace flownav::io {

void require_directory(const std::filesystem::path& directory);

/// Pictures of a folder, ordered by name with digits compared as numbers; hidden files (their names begin
/// with a point) are left out. Throws when there are none.
std::vector<std::filesystem::path> list_images(const std::filesystem::path& directory);

/// True for a name that ends as one of a picture that can be read.
bool has_picture_ending(const std::string& name);

/// A line of a text file that holds more than blanks.
struct TextLine {
    std::size_t number = 0;  ///< counted from 1
    std::string text;
};

/// Lines of a text file that hold more than blanks, without byte order mark and Windows line ends. Throws
/// when the file cannot be read, or is UTF-16.
std::vector<TextLine> read_text_lines(const std::filesystem::path& file);

/// The texts of these lines.
std::vector<std::string> read_lines(const std::filesystem::path& file);

/// Numbers of one line, separated by commas, semicolons or blanks; empty when the line holds other text. Does
/// not throw.
std::vector<double> numbers_of(const std::string& line);

}  // namespace flownav::io
