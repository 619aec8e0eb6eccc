#pragma once
#include <mrpt/config/CLoadableOptions.h>

#include <string>

#include "flownav/config/config.h"

namespace flownav::config {

/// One section of a Config as MRPT's classes read and write their options. The keys may stand in a section of
/// any name, among keys of others, such as the section of a driver in an ini of rawlog-grabber.
class ConfigSection : public mrpt::config::CLoadableOptions {
  public:
    /// `name` is a section of the ini: camera, flow, motion, obstacles, map, navigation or guard. `config`
    /// must outlive this.
    ConfigSection(Config& config, std::string name) : config_(config), name_(std::move(name)) {}

    /// Sets the keys of the section that the source has, by their present or earlier names. Throws
    /// ConfigError: a value that cannot be used.
    void loadFromConfigFile(const mrpt::config::CConfigFileBase& source, const std::string& section) override;
    void saveToConfigFile(mrpt::config::CConfigFileBase& target, const std::string& section) const override;

  private:
    Config& config_;
    std::string name_;
};

}  // namespace flownav::config
