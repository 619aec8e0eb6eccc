#include "numbered_files.h"

#include <algorithm>
#include <utility>

#include "flownav/config/config.h"

namespace flownav::io {

NumberedFiles::NumberedFiles(std::filesystem::path folder, const std::string& format)
    : folder_(std::move(folder)) {
    const auto percent = format.find('%');
    const auto letter = format.find_first_not_of("0123456789", percent + 1);
    const std::string width = format.substr(std::min(percent + 1, format.size()), letter - percent - 1);
    const bool one_number = percent != std::string::npos && letter != std::string::npos &&
                            format[letter] == 'd' && format.find('%', letter) == std::string::npos &&
                            width.size() <= 2;
    if (!one_number) {
        throw config::ConfigError("left_format = " + format +
                                  " is no name with one number (allowed: such as image_%05d.png)");
    }
    before_ = format.substr(0, percent);
    zeros_ = !width.empty() && width.front() == '0';
    width_ = width.empty() ? 0 : std::stoi(width);
    after_ = format.substr(letter + 1);
}

std::filesystem::path NumberedFiles::file(int index) const {
    std::string number = std::to_string(index);
    const auto width = static_cast<std::size_t>(width_);
    if (number.size() < width) number.insert(0, width - number.size(), zeros_ ? '0' : ' ');
    return folder_ / (before_ + number + after_);
}

bool NumberedFiles::exists(int index) const {
    std::error_code error;
    return std::filesystem::is_regular_file(file(index), error);
}

}  // namespace flownav::io
