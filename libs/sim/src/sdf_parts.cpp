#include "sdf_parts.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sdf_look.h"

namespace flownav::sim {
namespace {

std::vector<double> measures(const Shape& shape) {
    if (const auto* box = std::get_if<Box>(&shape))
        return {box->size_m.x(), box->size_m.y(), box->size_m.z()};
    if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return {cylinder->radius_m, cylinder->length_m};
    return {std::get<Sphere>(shape).radius_m};
}

bool same(const Solid& solid, const Shape& shape, const Eigen::Isometry3d& T) {
    return solid.shape.index() == shape.index() && measures(solid.shape) == measures(shape) &&
           solid.T_world_solid.isApprox(T, 1e-9);
}

}  // namespace

Eigen::Isometry3d to_isometry(const ignition::math::Pose3d& pose) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.translate(Eigen::Vector3d(pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z()));
    T.rotate(Eigen::Quaterniond(pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z()).normalized());
    if (!T.matrix().allFinite()) throw std::invalid_argument("a pose holds something that is not a number");
    return T;
}

Shape checked(const Shape& shape) {
    for (const double measure_m : measures(shape)) {
        if (!(measure_m > 0.0) || !std::isfinite(measure_m)) {
            throw std::invalid_argument("a shape has the measure " + text_of(measure_m) +
                                        "; it must be > 0 m");
        }
    }
    return shape;
}

void Parts::add_solid(const Shape& shape, const Eigen::Isometry3d& T, const std::string& name) {
    Solid solid;
    solid.name = name;
    solid.shape = shape;
    solid.T_world_solid = T;
    solid.look = default_look(name);
    solid.visible = false;
    solids_.push_back(std::move(solid));
}

void Parts::add_visible(const Shape& shape, const Eigen::Isometry3d& T, const std::optional<Look>& look,
                        const std::string& name) {
    const auto twin = std::find_if(solids_.begin(), solids_.end(),
                                   [&](const Solid& s) { return !s.visible && same(s, shape, T); });
    const bool alone = twin == solids_.end();
    if (alone) add_solid(shape, T, name);
    Solid& solid = alone ? solids_.back() : *twin;
    solid.visible = true;
    solid.solid = !alone;
    if (look) solid.look = *look;
}

void add_parts(World& world, const std::string& model, Parts parts) {
    std::vector<Solid> solids = parts.take();
    if (solids.size() == 1) {
        const bool default_looks = solids.front().look.seed == default_look(solids.front().name).seed;
        solids.front().name = model;
        if (default_looks) solids.front().look = default_look(model);
    }
    for (Solid& solid : solids) world.solids.push_back(std::move(solid));
}

}  // namespace flownav::sim
