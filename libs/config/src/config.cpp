#include "flownav/config/config.h"

#include <algorithm>

#include "config_key.h"
#include "nearest_key.h"

namespace flownav::config {
namespace {

using config::Key;
using config::key_table;

const Key& find_key(const std::string& full_name) {
    const auto dot = full_name.find('.');
    const std::string section = dot == std::string::npos ? "" : full_name.substr(0, dot);
    const std::string name = dot == std::string::npos ? full_name : full_name.substr(dot + 1);
    const auto& keys = key_table();
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const Key& key) {
        return key.doc.section == section && key.doc.name == name;
    });
    if (found != keys.end()) return *found;
    const ConfigKey& near = config::nearest_key(section, name).doc;
    throw ConfigError("unknown key " + full_name + "; the nearest known key is " + near.section + "." +
                      near.name + " (flownav-config --doc lists all)");
}

std::string in_brackets(const std::string& unit) {
    return unit.empty() ? "" : " (" + unit + ")";
}

std::string allowed(const ConfigKey& doc) {
    return "allowed: " + doc.range + in_brackets(doc.unit);
}

/// Where a comment was likely meant to begin.
std::string comment_hint(const std::string& value) {
    if (value.find_first_of("#;") == std::string::npos) return "";
    return "; a comment behind a value starts with //";
}

/// Calls action(key, whether it is the first of its section).
template <class Action>
void for_each_key(const Action& action) {
    std::string section;
    for (const Key& key : key_table()) {
        const bool first = key.doc.section != section;
        section = key.doc.section;
        action(key, first);
    }
}

}  // namespace

std::vector<ConfigKey> config_keys() {
    std::vector<ConfigKey> docs;
    docs.reserve(key_table().size());
    for (const Key& key : key_table()) docs.push_back(key.doc);
    return docs;
}

void set_config_value(Config& config, const std::string& key, const std::string& value) {
    const Key& known = find_key(key);
    try {
        known.set(config, value);
    } catch (const config::BadValue& error) {
        throw ConfigError(key + " = " + value + ": " + error.what() + "; " + allowed(known.doc) +
                          comment_hint(value));
    }
}

std::string dump_config(const Config& config) {
    std::string text = "# Settings of flownav. `recorded` means: as the recording has it.\n";
    for_each_key([&](const Key& key, bool first) {
        if (first) text += "\n[" + key.doc.section + "]\n";
        text += "# " + key.doc.help + in_brackets(key.doc.unit) + "; " + key.doc.range + "\n";
        text += key.doc.name + " = " + key.get(config) + "\n";
    });
    return text;
}

std::string dump_changes(const Config& config) {
    std::string text;
    std::string section;
    for (const Key& key : key_table()) {
        const std::string value = key.get(config);
        if (value == key.doc.default_value) continue;
        if (key.doc.section != section) text += "[" + key.doc.section + "]\n";
        section = key.doc.section;
        text += key.doc.name + " = " + value + "\n";
    }
    return text;
}

std::string document_config() {
    std::string text = "| key | default | allowed | unit | meaning |\n|---|---|---|---|---|\n";
    for (const ConfigKey& doc : config_keys()) {
        std::string range = doc.range;
        for (std::size_t at = 0; (at = range.find('|', at)) != std::string::npos; at += 2)
            range.insert(at, "\\");
        text += "| " + doc.section + "." + doc.name + " | " + doc.default_value + " | " + range + " | " +
                doc.unit + " | " + doc.help + " |\n";
    }
    return text;
}

}  // namespace flownav::config
