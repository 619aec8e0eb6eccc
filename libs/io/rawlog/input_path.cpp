#include "flownav/io/input_path.h"

#include <system_error>

namespace flownav::io {

std::string problem_of_input(const std::filesystem::path& input) {
    std::error_code error;
    const auto status = std::filesystem::status(input, error);
    const std::string name = input.string();
    if (status.type() == std::filesystem::file_type::not_found) return "there is no file " + name;
    if (error) return "cannot open " + name + ": " + error.message();
    if (std::filesystem::is_directory(status)) return name + " is a folder, not a rawlog";
    return {};
}

}  // namespace flownav::io
