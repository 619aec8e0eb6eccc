#pragma once
#include <string>
#include <vector>

namespace flownav::config {

/// One `name = value` line of an ini.
struct IniEntry {
    int line = 0;  ///< of the file, from 1
    std::string section, name, value;
};

/// Every entry of an ini text, in its order: MRPT reads the values (variables, formulas and comments
/// resolved), this finds what MRPT would pass over in silence. `file` only names the text in errors. Throws
/// ConfigError: a line that is neither a section, an entry nor a comment, an entry outside a section, a key
/// set twice, an undefined variable, a broken formula, or a file that is not text.
std::vector<IniEntry> parse_ini(const std::string& file, const std::string& text);

}  // namespace flownav::config
