#include "flownav/report/palette.h"

#include <array>
#include <cstdio>
#include <utility>

namespace flownav::report {

std::string Colour::css() const {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", red, green, blue);
    return text.data();
}

Colour colour_of(FieldStatus status) {
    switch (status) {
        case FieldStatus::Ok:
            return palette::green;
        case FieldStatus::Waiting:
            return {187, 187, 187};
        case FieldStatus::NoTexture:
            return palette::yellow;
        case FieldStatus::Lost:
            return palette::vermilion;
        case FieldStatus::BadField:
            break;
    }
    return palette::black;
}

std::string css_variables() {
    const std::pair<const char*, Colour> named[] = {
        {"black", palette::black},         {"orange", palette::orange}, {"sky-blue", palette::sky_blue},
        {"green", palette::green},         {"yellow", palette::yellow}, {"blue", palette::blue},
        {"vermilion", palette::vermilion}, {"purple", palette::purple}, {"ink", palette::ink},
        {"grey", palette::grey},           {"a", palette::run_a},       {"b", palette::run_b},
        {"truth", palette::run_truth}};
    std::string css = ":root {";
    for (const auto& [name, colour] : named) css += std::string(" --") + name + ": " + colour.css() + ";";
    return css + " }\n";
}

}  // namespace flownav::report
