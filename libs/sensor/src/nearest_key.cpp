#include "nearest_key.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace flownav::config {
namespace {

char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

/// Levenshtein's distance, blind to upper and lower case.
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

const Key& nearest_key(const std::string& section, const std::string& name) {
    // A key in the wrong section is likelier than two slips of the finger: names first, section on ties.
    const auto distance = [&](const Key& key) {
        return 4 * edit_distance(name, key.doc.name) +
               std::min<std::size_t>(3, edit_distance(section, key.doc.section));
    };
    const auto& keys = key_table();
    return *std::min_element(keys.begin(), keys.end(),
                             [&](const Key& a, const Key& b) { return distance(a) < distance(b); });
}

}  // namespace flownav::config
