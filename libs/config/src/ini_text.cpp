#include "ini_text.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/config/config_parser.h>
#include <mrpt/core/exceptions.h>
#include <mrpt/system/string_utils.h>

#include <map>
#include <sstream>

#include "flownav/config/config.h"

namespace flownav::config {
namespace {

using mrpt::system::lowerCase;
using mrpt::system::trim;

bool starts_with(const std::string& text, const std::string& start) {
    return text.rfind(start, 0) == 0;
}

[[noreturn]] void fail(const std::string& file, int line, const std::string& what) {
    throw ConfigError(file + ":" + std::to_string(line) + ": " + what);
}

std::vector<std::string> split_lines(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(trim(line));
    return lines;
}

/// The line of the file that each line starts on after MRPT has joined those ending in a backslash.
std::vector<int> first_lines(const std::string& text) {
    std::vector<int> numbers;
    int number = 0;
    bool continued = false;
    for (const std::string& line : split_lines(text)) {
        ++number;
        if (!continued) numbers.push_back(number);
        continued = !line.empty() && line.back() == '\\';
    }
    return numbers;
}

std::string expand_variables(const std::string& file, const std::string& text) {
    try {
        return mrpt::config::config_parser(text);
    } catch (const mrpt::ExceptionWithCallBackBase& error) {
        throw ConfigError(file + ": " + error.originalWhat);
    } catch (const std::exception& error) {
        throw ConfigError(file + ": " + error.what());
    }
}

std::string strip_byte_order_mark(const std::string& text) {
    return starts_with(text, "\xEF\xBB\xBF") ? text.substr(3) : text;
}

/// Reads the lines of an ini one by one and keeps their section.
class Scanner {
  public:
    Scanner(std::string file, const std::string& expanded) : file_(std::move(file)), values_(expanded) {}

    void read(int number, const std::string& line) {
        if (line.empty() || line[0] == '#' || line[0] == ';' || starts_with(line, "//")) return;
        if (line[0] == '[') return read_section(number, line);
        read_entry(number, line);
    }

    std::vector<IniEntry> entries;

  private:
    void read_section(int number, const std::string& line) {
        const auto close = line.find(']');
        const std::string rest = close == std::string::npos ? "" : trim(line.substr(close + 1));
        const bool only_comment = rest.empty() || starts_with(rest, "//") || rest[0] == '#' || rest[0] == ';';
        if (close == std::string::npos || !only_comment)
            fail(file_, number, "malformed section line: " + line);
        section_ = trim(line.substr(1, close - 1));
    }

    void read_entry(int number, const std::string& line) {
        const auto equals = line.find('=');
        const std::string name = trim(line.substr(0, equals));
        if (equals == std::string::npos || name.empty() || line[0] == '@')
            fail(file_, number, "malformed line, expected [section], name = value or a comment: " + line);
        if (section_.empty()) fail(file_, number, "key " + name + " stands before the first [section]");
        const auto [earlier, is_new] =
            lines_.emplace(lowerCase(present_setting({section_ + "." + name, ""}).key), number);
        if (!is_new) {
            fail(file_, number,
                 "key " + section_ + "." + name + " is set a second time; first in line " +
                     std::to_string(earlier->second));
        }
        entries.push_back({number, section_, name, values_.read_string(section_, name, "")});
    }

    std::string file_;
    mrpt::config::CConfigFileMemory values_;
    std::string section_;
    std::map<std::string, int>
        lines_;  ///< line of each key, by its present name in lower case, as MRPT compares
};

}  // namespace

std::vector<IniEntry> parse_ini(const std::string& file, const std::string& text) {
    if (text.find('\0') != std::string::npos) throw ConfigError(file + ": is not a text file");
    const std::string plain = strip_byte_order_mark(text);
    const std::string expanded = expand_variables(file, plain);
    const auto lines = split_lines(expanded);
    const auto numbers = first_lines(plain);
    Scanner scanner(file, expanded);
    for (std::size_t i = 0; i < lines.size(); ++i)
        scanner.read(i < numbers.size() ? numbers[i] : 0, lines[i]);
    return scanner.entries;
}

}  // namespace flownav::config
