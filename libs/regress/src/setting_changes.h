#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "flownav/regress/comparison.h"

namespace flownav::regress {

/// Collects what differs between the settings of two runs, over all rawlogs.
class SettingChanges {
  public:
    /// The settings of one rawlog, as inis of what is not the default.
    void add(const std::string& before, const std::string& after);

    std::vector<SettingChange> all() const;

  private:
    std::map<std::tuple<std::string, std::string, std::string>, std::size_t> rawlogs_;
};

}  // namespace flownav::regress
