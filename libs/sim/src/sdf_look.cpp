#include "sdf_look.h"

#include <array>
#include <charconv>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace flownav::sim {
namespace {

constexpr std::string_view prefix = "flownav/";
constexpr std::array<std::pair<Surface, std::string_view>, 10> surfaces = {{
    {Surface::Plain, "Plain"},
    {Surface::Carpet, "Carpet"},
    {Surface::Tiles, "Tiles"},
    {Surface::Lino, "Lino"},
    {Surface::Wall, "Wall"},
    {Surface::Patterned, "Patterned"},
    {Surface::Faint, "Faint"},
    {Surface::Stoneware, "Stoneware"},
    {Surface::Marbled, "Marbled"},
    {Surface::Lamp, "Lamp"},
}};

}  // namespace

std::string text_of(double value) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.begin(), text.end(), value == 0.0 ? 0.0 : value);
    return {text.begin(), end.ptr};
}

std::string name_of(const Look& look) {
    std::string name(prefix);
    for (const auto& [surface, word] : surfaces)
        if (surface == look.surface) name += word;
    return name + ' ' + text_of(look.grey) + ' ' + std::to_string(look.seed);
}

std::optional<Look> look_named(const std::string& name) {
    if (name.compare(0, prefix.size(), prefix) != 0) return std::nullopt;
    std::istringstream words(name.substr(prefix.size()));
    std::string word;
    Look look;
    words >> word >> look.grey >> look.seed;
    for (const auto& [surface, its_name] : surfaces) {
        if (its_name != word) continue;
        look.surface = surface;
        if (words && words.peek() == std::istringstream::traits_type::eof() && look.grey >= 0.0 &&
            look.grey <= 255.0)
            return look;
    }
    throw std::invalid_argument(
        "material \"" + name +
        "\" must be flownav/SURFACE GREY SEED with SURFACE = Plain, Carpet, Tiles, Lino, "
        "Wall, Patterned, Faint, Stoneware, Marbled or Lamp, GREY = 0..255 and SEED a whole number >= 0");
}

Look default_look(const std::string& name_of_solid) {
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (const char c : name_of_solid) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return {Surface::Patterned, 128.0, hash};
}

}  // namespace flownav::sim
