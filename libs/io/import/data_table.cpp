#include "data_table.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "flownav/io/errors.h"
#include "import_files.h"

namespace flownav::io {
namespace {

std::string trimmed(const std::string& text) {
    constexpr const char* around = " \t\r\"'";
    const auto begin = text.find_first_not_of(around);
    if (begin == std::string::npos) return "";
    return text.substr(begin, text.find_last_not_of(around) - begin + 1);
}

/// Separator of the cells of a line; a blank when there is no other.
char separator_of(const std::string& line) {
    for (const char separator : {';', ',', '\t'})
        if (line.find(separator) != std::string::npos) return separator;
    return ' ';
}

bool is_day(const std::string& text) {
    return text.size() == 10 && (text[4] == '-' || text[4] == '/') && text[7] == text[4] &&
           std::isdigit(static_cast<unsigned char>(text[0])) != 0;
}

bool is_time_of_day(const std::string& text) {
    return text.size() >= 8 && text[2] == ':' && text[5] == ':';
}

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) {
        const bool unit = word.front() == '[' || word.front() == '(';
        if (!words.empty() && (unit || (is_day(words.back()) && is_time_of_day(word)))) {
            words.back() += " " + word;
        } else {
            words.push_back(trimmed(word));
        }
    }
    return words;
}

}  // namespace

std::vector<std::string> cells_of(const std::string& line) {
    const std::string text = trimmed(line);
    const char separator = separator_of(text);
    if (separator == ' ') return words_of(text);
    std::vector<std::string> cells;
    std::istringstream stream(text);
    for (std::string cell; std::getline(stream, cell, separator);) cells.push_back(trimmed(cell));
    return cells;
}

DataTable read_table(const std::filesystem::path& file) {
    DataTable table;
    table.file = file;
    for (const TextLine& line : read_text_lines(file)) {
        const char first = line.text[line.text.find_first_not_of(" \t")];
        if (first != '#' && first != '%') {
            table.rows.push_back({line.number, cells_of(line.text)});
        } else if (table.rows.empty()) {
            const auto begin = line.text.find_first_not_of("#% \t");
            table.comment = cells_of(begin == std::string::npos ? "" : line.text.substr(begin));
        }
    }
    if (table.rows.empty()) throw InputError(file.string() + ": is empty");
    return table;
}

std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

}  // namespace flownav::io
