#include "sdf_ground.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "sdf_look.h"

namespace flownav::sim {
namespace {

constexpr double steepest_cosine = 0.93969262;  // 20 degrees

std::string text_in(const sdf::ElementPtr& element) {
    return element->GetValue() ? element->GetValue()->GetAsString() : "";
}

}  // namespace

bool is_ground(const std::string& model_name) {
    return model_name.rfind("ground", 0) == 0;
}

bool is_walkable(const Eigen::Isometry3d& T_world_surface) {
    return T_world_surface.linear()(2, 2) >= steepest_cosine;
}

std::string model_of(const std::string& part_name) {
    const auto part = part_name.rfind('/');
    const auto link =
        part == std::string::npos || part == 0 ? std::string::npos : part_name.rfind('/', part - 1);
    return link == std::string::npos ? part_name : part_name.substr(0, link);
}

Look default_ground_look(const std::string& name) {
    return {Surface::Carpet, 128.0, default_look(name).seed};
}

void add_ground(World& world, const GroundPiece& piece, bool is_visual) {
    const auto twin = std::find_if(world.ground.begin(), world.ground.end(), [&](const GroundPiece& other) {
        return other.size_m == piece.size_m && other.T_world_ground.isApprox(piece.T_world_ground, 1e-9);
    });
    if (twin == world.ground.end()) {
        world.ground.push_back(piece);
    } else if (is_visual) {
        twin->look = piece.look;
    }
}

Parts take_ground(World& world, Parts& parts) {
    Parts others;
    for (Solid& solid : parts.take()) {
        const auto* box = std::get_if<Box>(&solid.shape);
        if (!box || !is_walkable(solid.T_world_solid)) {
            others.add(std::move(solid));
            continue;
        }
        GroundPiece piece;
        piece.name = model_of(solid.name);
        piece.T_world_ground = solid.T_world_solid * Eigen::Translation3d(0.0, 0.0, box->size_m.z() / 2);
        piece.size_m = box->size_m.head<2>();
        const bool has_look = solid.look.seed != default_look(solid.name).seed;
        piece.look = has_look ? solid.look : default_ground_look(solid.name);
        add_ground(world, piece, true);
    }
    return others;
}

std::optional<ShadowLight> shadow_light_of(const sdf::ElementPtr& world) {
    if (!world || !world->HasElement(shadows_element)) return std::nullopt;
    const std::string text = text_in(world->GetElement(shadows_element));
    std::istringstream words(text);
    ShadowLight light;
    std::string rest;
    const bool read = static_cast<bool>(words >> light.towards.x() >> light.towards.y() >>
                                        light.towards.z() >> light.loss >> light.soft_m);
    if (!read || words >> rest || !light.towards.allFinite() || !(light.towards.z() > 0.0) ||
        !(light.loss >= 0.0 && light.loss <= 1.0) || !(light.soft_m >= 0.0 && light.soft_m <= 10.0)) {
        throw std::invalid_argument(
            std::string(shadows_element) + " \"" + text +
            "\" must be X Y Z LOSS SOFT_M: the direction to the light with Z > 0, the share "
            "of light that is lost, 0..1, and the width of the edge, 0..10 m");
    }
    return light;
}

}  // namespace flownav::sim
