#include "numbered_files.h"

#include <regex>
#include <utility>

#include "flownav/sensor/config.h"

namespace flownav::producer {

NumberedFiles::NumberedFiles(std::filesystem::path folder, const std::string& format)
    : folder_(std::move(folder)) {
    static const std::regex one_number("([^%]*)%(0?)([1-9]?)d([^%]*)");
    std::smatch parts;
    if (!std::regex_match(format, parts, one_number)) {
        throw ConfigError("left_format = " + format +
                          " is no name with one number (allowed: such as image_%05d.png)");
    }
    before_ = parts[1];
    zeros_ = parts[2].length() > 0;
    width_ = parts[3].length() > 0 ? std::stoi(parts[3]) : 0;
    after_ = parts[4];
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

}  // namespace flownav::producer
