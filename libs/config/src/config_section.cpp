#include "flownav/config/config_section.h"

#include <mrpt/config/CConfigFileBase.h>

#include "config_key.h"

namespace flownav::config {

void ConfigSection::loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                                       const std::string& section) {
    const std::string prefix = name_ + ".";
    const auto load = [&](const std::string& full_name) {
        if (full_name.rfind(prefix, 0) != 0) return;
        const std::string name = full_name.substr(prefix.size());
        if (source.keyExists(section, name))
            set_config_value(config_, full_name, source.read_string(section, name, ""));
    };
    for (const Key& key : key_table()) {
        for (const std::string& earlier : key.doc.earlier_names) load(earlier);
        load(key.doc.full_name());
    }
}

void ConfigSection::saveToConfigFile(mrpt::config::CConfigFileBase& target,
                                     const std::string& section) const {
    constexpr int unpadded = -1;  // MRPT keeps padding as part of a name in memory
    for (const Key& key : key_table()) {
        if (key.doc.section != name_) continue;
        target.write(section, key.doc.name, key.get(config_), unpadded, unpadded, key.doc.help);
    }
}

}  // namespace flownav::config
