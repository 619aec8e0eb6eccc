#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "flownav/regress/comparison.h"

namespace flownav::regress {

/// Collects the settings that differ between two runs, over all rawlogs.
class SettingChanges {
  public:
    /// Adds the settings of one rawlog: two inis with the values that are not defaults.
    void add(const std::string& before, const std::string& after);

    std::vector<SettingChange> all() const;

  private:
    std::map<std::tuple<std::string, std::string, std::string>, std::size_t> rawlogs_;
};

}  // namespace flownav::regress
