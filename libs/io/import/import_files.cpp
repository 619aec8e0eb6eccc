#include "import_files.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>

#include "data_table.h"
#include "flownav/io/rawlog_reader.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;

bool is_image(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.front() != '.' && has_picture_ending(name);
}

bool starts_with(const std::string& text, const char* beginning) {
    return text.rfind(beginning, 0) == 0;
}

std::size_t end_of_digits(const std::string& text, std::size_t begin) {
    while (begin < text.size() && std::isdigit(static_cast<unsigned char>(text[begin])) != 0) ++begin;
    return begin;
}

/// Compares runs of digits as numbers: img9 comes before img10.
bool natural_less(const std::string& a, const std::string& b) {
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() && j < b.size()) {
        const std::size_t i_end = end_of_digits(a, i);
        const std::size_t j_end = end_of_digits(b, j);
        if (i_end > i && j_end > j) {
            while (i < i_end && a[i] == '0') ++i;
            while (j < j_end && b[j] == '0') ++j;
            if (i_end - i != j_end - j) return i_end - i < j_end - j;
            const int order = a.compare(i, i_end - i, b, j, j_end - j);
            if (order != 0) return order < 0;
            i = i_end;
            j = j_end;
        } else {
            if (a[i] != b[j]) return a[i] < b[j];
            ++i;
            ++j;
        }
    }
    return a.size() - i < b.size() - j || (a.size() - i == b.size() - j && a < b);
}

}  // namespace

bool has_picture_ending(const std::string& name) {
    static constexpr const char* endings[] = {".png", ".jpg", ".jpeg", ".bmp",  ".pgm",
                                              ".ppm", ".pnm", ".tif",  ".tiff", ".webp"};
    const std::string ending = lower_case(fs::path(name).extension().string());
    return std::find(std::begin(endings), std::end(endings), ending) != std::end(endings);
}

void require_directory(const fs::path& directory) {
    if (!fs::exists(directory)) throw InputError(directory.string() + ": no such folder");
    if (!fs::is_directory(directory)) throw InputError(directory.string() + ": is not a folder");
}

std::vector<fs::path> list_images(const fs::path& directory) {
    require_directory(directory);
    std::vector<fs::path> images;
    for (const auto& entry : fs::directory_iterator(directory)) {
        if (entry.is_regular_file() && is_image(entry.path())) images.push_back(entry.path());
    }
    if (images.empty()) {
        throw InputError(directory.string() + ": holds no images (png, jpg, bmp, pgm, ppm, tif, webp)");
    }
    std::sort(images.begin(), images.end(), [](const fs::path& a, const fs::path& b) {
        return natural_less(a.filename().string(), b.filename().string());
    });
    return images;
}

std::vector<TextLine> read_text_lines(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || fs::is_directory(file)) throw InputError(file.string() + ": cannot be read");
    std::vector<TextLine> lines;
    std::size_t number = 0;
    for (std::string line; std::getline(stream, line);) {
        if (++number == 1 && starts_with(line, "\xEF\xBB\xBF")) line.erase(0, 3);
        if (number == 1 && (starts_with(line, "\xFF\xFE") || starts_with(line, "\xFE\xFF")))
            throw InputError(file.string() + ": is UTF-16 text; save it as UTF-8");
        while (!line.empty() && line.back() == '\r') line.pop_back();
        if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back({number, line});
    }
    return lines;
}

std::vector<std::string> read_lines(const fs::path& file) {
    std::vector<std::string> texts;
    for (TextLine& line : read_text_lines(file)) texts.push_back(std::move(line.text));
    return texts;
}

std::vector<double> numbers_of(const std::string& line) {
    std::string text = line;
    for (char& c : text) {
        if (c == ',' || c == ';' || c == '\r') c = ' ';
    }
    std::istringstream stream(text);
    std::vector<double> numbers;
    for (std::string word; stream >> word;) {
        char* end = nullptr;
        numbers.push_back(std::strtod(word.c_str(), &end));
        if (*end != '\0' || !std::isfinite(numbers.back())) return {};
    }
    return numbers;
}

}  // namespace flownav::io
