#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "score.h"

namespace flownav::fidelity {

/// Settings that differ from the default, under a name.
struct Variant {
    std::string name;
    std::vector<std::pair<std::string, std::string>> settings;  ///< section.key, value
};

/// The default configuration with a variant's settings. Throws ConfigError.
config::Config config_of(const Variant& variant);

/// Where scenes come from, and where the work is said to be.
struct Studio {
    std::filesystem::path cache;  ///< of rendered pictures; empty: none
    std::uint64_t seed = 1;
    bool quiet = false;

    RenderedScene scene(const std::string& preset_name) const;
    void say(const std::string& what) const;  ///< on the standard error
};

/// The scores of every scene (rows) with every variant (columns), on all processors.
std::vector<std::vector<Score>> scores_of(const Studio& studio, const std::vector<std::string>& scenes,
                                          const std::vector<Variant>& variants);

/// Calls `work` for 0 .. count - 1 on all processors; the first exception is thrown again at the end.
void in_parallel(int count, const std::function<void(int)>& work);

}  // namespace flownav::fidelity
