#include "object_header.h"

#include <algorithm>
#include <cctype>

namespace flownav::io {

bool is_class_name(const std::string& name) {
    const auto allowed = [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == ':' || c == '<' || c == '>' || c == ',' || c == ' ';
    };
    return !name.empty() && (std::isalpha(static_cast<unsigned char>(name.front())) != 0) &&
           std::all_of(name.begin(), name.end(), allowed);
}

ObjectHeader parse_object_header(const std::vector<std::uint8_t>& bytes) {
    if (bytes.empty()) return {ObjectHeader::Kind::TooShort, ""};
    const bool old_format = (bytes[0] & 0x80) == 0;
    const std::size_t length = bytes[0] & 0x7F;
    const std::size_t begin = old_format ? 4 : 1;
    for (std::size_t i = 1; i < begin && i < bytes.size(); ++i) {
        if (bytes[i] != 0) return {};
    }
    const std::size_t end = std::min(begin + length, bytes.size());
    const std::string name(bytes.begin() + static_cast<std::ptrdiff_t>(std::min(begin, end)),
                           bytes.begin() + static_cast<std::ptrdiff_t>(end));
    const bool short_of_bytes = bytes.size() < begin + length;
    if (short_of_bytes && (name.empty() || is_class_name(name))) return {ObjectHeader::Kind::TooShort, name};
    if (!is_class_name(name)) return {};
    return {ObjectHeader::Kind::Good, name};
}

}  // namespace flownav::io
