#include "flownav/flow/matcher_registry.h"

#include <stdexcept>

#include "flownav/core/registry.h"

namespace flownav::flow {
namespace {

Registry<MatcherFactory>& matchers() {
    static Registry<MatcherFactory> all(
        "matcher",
        {
            {"sad", [](const FlowParams& params, int threads) { return BlockMatcher(params, threads); }},
        });
    return all;
}

}  // namespace

void register_matcher(const std::string& name, MatcherFactory factory) {
    if (!factory) throw std::invalid_argument("register_matcher: '" + name + "' has no factory");
    matchers().add(name, std::move(factory));
}

Matcher make_matcher(const std::string& name, const FlowParams& params, int threads) {
    return matchers().find(name)(params, threads);
}

std::vector<std::string> matcher_names() {
    return matchers().names();
}

}  // namespace flownav::flow
