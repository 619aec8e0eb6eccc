#include "flownav/regress/column_file.h"

#include <charconv>
#include <cmath>
#include <fstream>

namespace flownav::regress {

namespace {

std::vector<std::string> cells_of(const std::string& line, char separator) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
        if (c == separator) {
            cells.emplace_back();
        } else if (c != '\r') {
            cells.back() += c;
        }
    }
    return cells;
}

double number_of(const std::string& cell) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return error == std::errc() && end == cell.data() + cell.size() ? value : std::nan("");
}

/// Cells beyond the names are ignored; missing cells become NaN.
Columns read_rows(std::istream& stream, const std::vector<std::string>& names, char separator) {
    Columns columns;
    for (std::string line; std::getline(stream, line);) {
        const std::vector<std::string> cells = cells_of(line, separator);
        for (std::size_t k = 0; k < names.size(); ++k)
            columns[names[k]].push_back(k < cells.size() ? number_of(cells[k]) : std::nan(""));
    }
    return columns;
}

}  // namespace

Columns read_csv(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string head;
    if (!std::getline(stream, head)) return {};
    return read_rows(stream, cells_of(head, ','), ',');
}

Columns read_tum(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return read_rows(stream, {"timestamp", "x", "y"}, ' ');
}

}  // namespace flownav::regress
