#include "flownav/config/config_section.h"

#include <mrpt/config/CConfigFileBase.h>

#include "config_key.h"

namespace flownav::config {

void ConfigSection::loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                                       const std::string& section) {
    for (const config::Key& key : config::key_table()) {
        const ConfigKey& doc = key.doc;
        if (doc.section != name_ || !source.keyExists(section, doc.name)) continue;
        set_config_value(config_, doc.section + "." + doc.name, source.read_string(section, doc.name, ""));
    }
}

void ConfigSection::saveToConfigFile(mrpt::config::CConfigFileBase& target,
                                     const std::string& section) const {
    constexpr int unpadded = -1;  // MRPT keeps padding as part of a name in memory
    for (const config::Key& key : config::key_table()) {
        if (key.doc.section != name_) continue;
        target.write(section, key.doc.name, key.get(config_), unpadded, unpadded, key.doc.help);
    }
}

}  // namespace flownav::config
