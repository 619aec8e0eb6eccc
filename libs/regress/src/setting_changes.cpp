#include "setting_changes.h"

#include <mrpt/config/CConfigFileMemory.h>

#include <set>

#include "flownav/config/config.h"

namespace flownav::regress {

namespace {

using Settings = std::map<std::string, std::string>;

std::string setting_name(const std::string& section, const std::string& key) {
    return section + '.' + key;
}

Settings settings_of(const std::string& text) {
    Settings settings;
    const mrpt::config::CConfigFileMemory ini(text);
    std::vector<std::string> sections, keys;
    ini.getAllSections(sections);
    for (const std::string& section : sections) {
        ini.getAllKeys(section, keys);
        for (const std::string& key : keys) {
            const config::Setting setting =
                config::present_setting({setting_name(section, key), ini.read_string(section, key, "")});
            settings[setting.key] = setting.value;
        }
    }
    return settings;
}

std::string default_of(const std::string& name) {
    static const Settings defaults = [] {
        Settings values;
        for (const config::ConfigKey& key : config::config_keys())
            values[setting_name(key.section, key.name)] = key.default_value;
        return values;
    }();
    const auto found = defaults.find(name);
    return found == defaults.end() ? "default" : found->second + " (default)";
}

std::string value_in(const Settings& settings, const std::string& name) {
    const auto found = settings.find(name);
    return found == settings.end() ? default_of(name) : found->second;
}

}  // namespace

void SettingChanges::add(const std::string& before, const std::string& after) {
    if (before == after) return;
    const Settings was = settings_of(before);
    const Settings is = settings_of(after);
    std::set<std::string> names;
    for (const Settings* settings : {&was, &is})
        for (const auto& [name, value] : *settings) names.insert(name);
    for (const std::string& name : names) {
        const std::string old = value_in(was, name);
        const std::string now = value_in(is, name);
        if (old != now) ++rawlogs_[{name, old, now}];
    }
}

std::vector<SettingChange> SettingChanges::all() const {
    std::vector<SettingChange> changes;
    for (const auto& [what, rawlogs] : rawlogs_) {
        const auto& [key, before, after] = what;
        changes.push_back({key, before, after, rawlogs});
    }
    return changes;
}

}  // namespace flownav::regress
