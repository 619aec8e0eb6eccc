#pragma once
#include <string>
#include <vector>

namespace flownav::config {

/// One `name = value` line of an ini.
struct IniEntry {
    int line = 0;  ///< of the file, from 1
    std::string section, name, value;
};

/// Returns the entries of an ini text in their order. A section may stand more than once. MRPT resolves
/// variables, formulas and comments. `file` names the text in errors. Throws ConfigError: a line that is
/// neither a section, an entry nor a comment, an entry outside a section, a key set twice (also once by an
/// earlier name), an undefined variable, a broken formula, or a file that is not text.
std::vector<IniEntry> parse_ini(const std::string& file, const std::string& text);

}  // namespace flownav::config
