#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "score.h"

namespace flownav::fidelity {

/// Named settings that differ from the default.
struct Variant {
    std::string name;
    std::vector<std::pair<std::string, std::string>> settings;  ///< section.key, value
    bool wheels = false;                                        ///< see RenderedScene
};

/// The default configuration with a variant's settings. Throws ConfigError.
config::Config config_of(const Variant& variant);

/// Source of the scenes, and progress output.
struct Studio {
    std::filesystem::path cache;  ///< folder of rendered images; empty: none
    std::uint64_t seed = 1;
    bool quiet = false;

    RenderedScene scene(const std::string& preset_name) const;
    void say(const std::string& what) const;  ///< writes to the standard error
};

/// Computes the scores of every scene (rows) with every variant (columns), on all processors.
std::vector<std::vector<Score>> scores_of(const Studio& studio, const std::vector<std::string>& scenes,
                                          const std::vector<Variant>& variants);

/// Calls `work` for 0 .. count - 1 on all processors; rethrows the first exception at the end.
void in_parallel(int count, const std::function<void(int)>& work);

}  // namespace flownav::fidelity
