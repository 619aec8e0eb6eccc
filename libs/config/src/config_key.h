#pragma once
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/config/config_value.h"
#include "renamed.h"

// A member of a Config, whether const or not.
#define AT(member) ([](auto& config) -> auto& { return (config.member); })

namespace flownav::config {

/// One key of the ini: its documentation, and how it reads and writes its place in a Config.
struct Key {
    ConfigKey doc;
    std::function<std::string(const Config&)> get;
    std::function<void(Config&, const std::string&)> set;  ///< throws BadValue
};

/// All keys, the keys of a section side by side. A key is one entry in the function of its section.
const std::vector<Key>& key_table();

std::vector<Key> navigation_keys();
std::vector<Key> guard_keys();

/// The words of a text, separated by blanks or commas.
inline std::vector<std::string> words_of(const std::string& text) {
    constexpr auto separators = " \t,";
    std::vector<std::string> words;
    for (auto begin = text.find_first_not_of(separators); begin != std::string::npos;) {
        const auto end = text.find_first_of(separators, begin);
        words.push_back(text.substr(begin, end - begin));
        begin = text.find_first_not_of(separators, end);
    }
    return words;
}

/// Marks the keys that most users set; at most 30. All others are advanced.
inline constexpr bool everyday = true;

/// The parts of a key's documentation that are written by hand.
struct Doc {
    const char* section;
    const char* name;
    const char* unit;
    const char* help;
    bool is_everyday = false;
};

inline Key make_key(const Doc& doc, std::string range, const decltype(Key::get)& get,
                    decltype(Key::set) set) {
    ConfigKey key{doc.section,      doc.name, get(Config{}),   doc.unit,
                  std::move(range), doc.help, doc.is_everyday, {}};
    for (const RenamedKey& renamed : renamed_keys) {
        if (renamed.present == key.full_name()) key.earlier_names.emplace_back(renamed.earlier);
    }
    return {std::move(key), get, std::move(set)};
}

/// A number. `place` returns a reference to its member of a Config; `others` are members that get the same
/// value.
template <class T, class Place, class... Others>
Key number(const Doc& doc, Range<T> range, Place place, Others... others) {
    return make_key(
        doc, describe(range), [=](const Config& config) { return format_number(place(config)); },
        [=](Config& config, const std::string& text) {
            const T value = parse_number(text, range);
            place(config) = value;
            ((others(config) = value), ...);
        });
}

/// A whole number, or `word` in place of `word_value`.
template <class Place>
Key number_or_word(const Doc& doc, Range<int> range, int word_value, const char* word, Place place) {
    const std::string word_text = word;
    return make_key(
        doc, describe(range) + ", or " + word_text,
        [=](const Config& config) {
            return place(config) == word_value ? word_text : format_number(place(config));
        },
        [=](Config& config, const std::string& text) {
            place(config) = text == word_text ? word_value : parse_number(text, range);
        });
}

/// A number that the recording has as well; the word `recorded` keeps that one.
template <class Place>
Key recorded_number(const Doc& doc, Range<double> range, Place place) {
    return make_key(
        doc, describe(range) + ", or recorded",
        [=](const Config& config) { return place(config) ? format_number(*place(config)) : "recorded"; },
        [=](Config& config, const std::string& text) {
            place(config) = text == "recorded" ? std::nullopt : std::optional(parse_number(text, range));
        });
}

/// One of a few words.
template <class T, class Place>
Key word(const Doc& doc, std::vector<std::pair<const char*, T>> words, Place place) {
    std::string range;
    for (const auto& [text, value] : words) range += (range.empty() ? "" : " | ") + std::string(text);
    const auto get = [=](const Config& config) -> std::string {
        for (const auto& [text, value] : words) {
            if (value == place(config)) return text;
        }
        return "";
    };
    const auto set = [=](Config& config, const std::string& wanted) {
        for (const auto& [text, value] : words) {
            if (wanted != text) continue;
            place(config) = value;
            return;
        }
        throw BadValue("is none of the words");
    };
    return make_key(doc, range, get, set);
}

}  // namespace flownav::config
