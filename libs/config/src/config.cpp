#include "flownav/config/config.h"

#include <algorithm>
#include <iostream>
#include <mutex>
#include <set>

#include "config_key.h"
#include "nearest_key.h"

namespace flownav::config {
namespace {

/// Writes the sentence to stderr, once a process.
void warn_once(const std::string& sentence) {
    static std::mutex mutex;
    static std::set<std::string> written;
    const std::lock_guard<std::mutex> lock(mutex);
    if (written.insert(sentence).second) std::cerr << "flownav: warning: " << sentence << '\n';
}

/// The present names of the setting; warns when it has earlier ones.
Setting renamed_with_warning(const Setting& given) {
    Setting present = present_setting(given);
    if (present.key != given.key) {
        warn_once("the key " + given.key + " is now called " + present.key +
                  "; the next version will not know the old name");
    }
    if (present.value != given.value) {
        warn_once(present.key + " = " + given.value + " is now written " + present.key + " = " +
                  present.value + "; the next version will not know the old word");
    }
    return present;
}

const Key& find_key(const std::string& full_name) {
    const auto dot = full_name.find('.');
    const std::string section = dot == std::string::npos ? "" : full_name.substr(0, dot);
    const std::string name = dot == std::string::npos ? full_name : full_name.substr(dot + 1);
    const auto& keys = key_table();
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const Key& key) {
        return key.doc.section == section && key.doc.name == name;
    });
    if (found != keys.end()) return *found;
    const ConfigKey& near = nearest_key(section, name).doc;
    throw ConfigError("unknown key " + full_name + "; the nearest known key is " + near.section + "." +
                      near.name + " (flownav-config --doc lists all)");
}

std::string in_brackets(const std::string& unit) {
    return unit.empty() ? "" : " (" + unit + ")";
}

std::string allowed(const ConfigKey& doc) {
    return "allowed: " + doc.range + in_brackets(doc.unit);
}

/// A hint for values that contain the beginning of a comment; empty for all others.
std::string comment_hint(const std::string& value) {
    if (value.find_first_of("#;") == std::string::npos) return "";
    return "; a comment behind a value starts with //";
}

/// The keys of the table that are everyday keys, or those that are not.
std::vector<Key> keys_of_use(bool is_everyday) {
    std::vector<Key> keys;
    for (const Key& key : key_table()) {
        if (key.doc.everyday == is_everyday) keys.push_back(key);
    }
    return keys;
}

/// The ini text of the keys, each with its documentation, under the headings of their sections.
std::string dump_keys(const Config& config, const std::vector<Key>& keys) {
    std::string text;
    std::string section;
    for (const Key& key : keys) {
        if (key.doc.section != section) text += "\n[" + key.doc.section + "]\n";
        section = key.doc.section;
        text += "# " + key.doc.help + in_brackets(key.doc.unit) + "; " + key.doc.range + "\n";
        text += key.doc.name + " = " + key.get(config) + "\n";
    }
    return text;
}

std::string row_of(const ConfigKey& doc) {
    std::string range = doc.range;
    for (std::size_t at = 0; (at = range.find('|', at)) != std::string::npos; at += 2) range.insert(at, "\\");
    return "| " + doc.full_name() + " | " + doc.default_value + " | " + range + " | " + doc.unit + " | " +
           (doc.everyday ? "everyday" : "advanced") + " | " + doc.help + " |\n";
}

}  // namespace

std::vector<ConfigKey> config_keys() {
    std::vector<ConfigKey> docs;
    docs.reserve(key_table().size());
    for (const Key& key : key_table()) docs.push_back(key.doc);
    return docs;
}

void set_config_value(Config& config, const std::string& key, const std::string& value) {
    const Setting setting = renamed_with_warning({key, value});
    const Key& known = find_key(setting.key);
    try {
        known.set(config, setting.value);
    } catch (const BadValue& error) {
        throw ConfigError(setting.key + " = " + setting.value + ": " + error.what() + "; " +
                          allowed(known.doc) + comment_hint(setting.value));
    }
}

std::string config_value(const Config& config, const std::string& key) {
    return find_key(key).get(config);
}

std::string dump_config(const Config& config, KeySet keys) {
    std::string text = "# Settings of flownav. `recorded` means: as the recording has it.\n";
    text += dump_keys(config, keys_of_use(true));
    if (keys == KeySet::Everyday) return text;
    text +=
        "\n"
        "# ------------------------------------------------------------------------------------------\n"
        "# Advanced: the defaults suit most robots. A section may stand a second time.\n"
        "# ------------------------------------------------------------------------------------------\n";
    return text + dump_keys(config, keys_of_use(false));
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

std::string document_config(KeySet keys) {
    std::string text = "| key | default | allowed | unit | use | meaning |\n|---|---|---|---|---|---|\n";
    for (const Key& key : keys_of_use(true)) text += row_of(key.doc);
    if (keys == KeySet::Everyday) return text;
    for (const Key& key : keys_of_use(false)) text += row_of(key.doc);
    return text;
}

}  // namespace flownav::config
