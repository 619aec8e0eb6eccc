#include "flownav/sim/world_look.h"

namespace flownav::sim {

const char* to_string(ObjectLook look) {
    switch (look) {
        case ObjectLook::Real:
            return "real";
        case ObjectLook::Patterned:
            return "patterned";
        case ObjectLook::Faint:
            return "faint";
        case ObjectLook::Plain:
            return "plain";
    }
    return "";
}

void set_objects(World& world, ObjectLook look, std::uint64_t seed) {
    if (look == ObjectLook::Real) return furnish_as_real(world, seed);
    const Surface surface = look == ObjectLook::Patterned ? Surface::Patterned
                            : look == ObjectLook::Faint   ? Surface::Faint
                                                          : Surface::Plain;
    for (Solid& solid : world.solids)
        if (solid.look.surface != Surface::Lamp) solid.look.surface = surface;
}

const std::vector<std::pair<std::string, Surface>>& floor_surfaces() {
    static const std::vector<std::pair<std::string, Surface>> words = {
        {"carpet", Surface::Carpet}, {"tiles", Surface::Tiles},         {"lino", Surface::Lino},
        {"plain", Surface::Plain},   {"stoneware", Surface::Stoneware}, {"marbled", Surface::Marbled}};
    return words;
}

}  // namespace flownav::sim
