#include "studio.h"

#include <exception>
#include <iostream>

#include "flownav/testing/presets.h"

namespace flownav::fidelity {

config::Config config_of(const Variant& variant) {
    config::Config config;
    for (const auto& [key, value] : variant.settings) config::set_config_value(config, key, value);
    return config;
}

RenderedScene Studio::scene(const std::string& preset_name) const {
    const auto options = testing::preset(preset_name, seed);
    if (!options) throw config::ConfigError("scene '" + preset_name + "' is unknown");
    return render_scene(preset_name + '-' + std::to_string(seed), *options, cache);
}

void Studio::say(const std::string& what) const {
    if (!quiet) std::cerr << what << std::endl;
}

void in_parallel(int count, const std::function<void(int)>& work) {
    std::exception_ptr trouble;
#pragma omp parallel for schedule(dynamic)
    for (int i = 0; i < count; ++i) {
        try {
            work(i);
        } catch (...) {
#pragma omp critical
            if (!trouble) trouble = std::current_exception();
        }
    }
    if (trouble) std::rethrow_exception(trouble);
}

std::vector<std::vector<Score>> scores_of(const Studio& studio, const std::vector<std::string>& scenes,
                                          const std::vector<Variant>& variants) {
    std::vector<std::vector<Score>> scores(scenes.size());
    in_parallel(static_cast<int>(scenes.size()), [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        RenderedScene drive = studio.scene(scenes[k]);
        for (const Variant& variant : variants) {
            drive.wheels = variant.wheels;
            scores[k].push_back(evaluate(drive, config_of(variant)));
        }
        studio.say("  " + scenes[k]);
    });
    return scores;
}

}  // namespace flownav::fidelity
