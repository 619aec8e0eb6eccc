#include "renamed.h"

#include "flownav/config/config.h"

namespace flownav::config {

Setting present_setting(Setting setting) {
    for (const RenamedKey& renamed : renamed_keys) {
        if (setting.key == renamed.earlier) setting.key = renamed.present;
    }
    for (const RenamedWord& renamed : renamed_words) {
        if (setting.key == renamed.key && setting.value == renamed.earlier) setting.value = renamed.present;
    }
    return setting;
}

}  // namespace flownav::config
