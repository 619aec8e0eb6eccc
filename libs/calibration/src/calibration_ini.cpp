#include "calibration_ini.h"

#include <algorithm>

#include "flownav/cli/number_text.h"

namespace flownav::calibration {
namespace {

constexpr int decimals = 4;

const CalibratedValue* calibrated(const std::vector<CalibratedValue>& values, const config::ConfigKey& key) {
    const auto found = std::find_if(values.begin(), values.end(), [&key](const CalibratedValue& value) {
        return key.section == "camera" && key.name == value.key && value.determined;
    });
    return found == values.end() ? nullptr : &*found;
}

/// Replaces line breaks and backslashes, which file names may contain, because they would end a comment.
std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\\'; }, ' ');
    return text;
}

}  // namespace

std::string describe(const CalibratedValue& value) {
    const std::string before = cli::fixed_text(value.before, decimals) + ' ' + value.unit;
    if (!value.determined) return value.key + ": not determined by this drive; it stays " + before;
    return value.key + " = " + cli::fixed_text(value.after, decimals) + ' ' + value.unit + ", uncertainty " +
           cli::fixed_text(value.sigma, decimals) + ", before " + before;
}

std::string calibration_ini(const config::Config& given, const std::vector<CalibratedValue>& values,
                            const std::vector<std::string>& header) {
    std::string text;
    for (const std::string& line : header) text += "# " + one_line(line) + '\n';
    std::string section;
    for (const config::ConfigKey& key : config::config_keys()) {
        const CalibratedValue* value = calibrated(values, key);
        const std::string setting = config::config_value(given, key.full_name());
        if (value == nullptr && setting == key.default_value) continue;
        if (key.section != section) text += "\n[" + key.section + "]\n";
        section = key.section;
        if (value != nullptr) text += "# uncertainty " + cli::fixed_text(value->sigma, decimals) + '\n';
        text +=
            key.name + " = " + (value != nullptr ? cli::fixed_text(value->after, decimals) : setting) + '\n';
    }
    return text;
}

}  // namespace flownav::calibration
