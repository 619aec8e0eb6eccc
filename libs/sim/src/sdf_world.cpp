#include "flownav/sim/sdf_world.h"

#include <cmath>
#include <ignition/math/Pose3.hh>
#include <sdf/Box.hh>
#include <sdf/Collision.hh>
#include <sdf/Cylinder.hh>
#include <sdf/Frame.hh>
#include <sdf/Geometry.hh>
#include <sdf/Link.hh>
#include <sdf/Material.hh>
#include <sdf/Model.hh>
#include <sdf/Plane.hh>
#include <sdf/Sphere.hh>
#include <sdf/Visual.hh>
#include <sdf/World.hh>

#include "sdf_actor.h"
#include "sdf_file.h"
#include "sdf_ground.h"
#include "sdf_look.h"
#include "sdf_parts.h"

namespace flownav::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/// Pose in the frame of the parent.
template <class Thing>
Isometry3d pose_of(const Thing& thing) {
    ignition::math::Pose3d pose;
    const sdf::Errors errors = thing.SemanticPose().Resolve(pose);
    if (!errors.empty()) throw std::invalid_argument(errors.front().Message());
    return to_isometry(pose);
}

std::optional<Shape> shape_of(const sdf::Geometry& geometry) {
    if (const auto* box = geometry.BoxShape())
        return checked(Box{{box->Size().X(), box->Size().Y(), box->Size().Z()}});
    if (const auto* c = geometry.CylinderShape()) return checked(Cylinder{c->Radius(), c->Length()});
    if (const auto* sphere = geometry.SphereShape()) return checked(Sphere{sphere->Radius()});
    return std::nullopt;
}

std::optional<Look> look_of(const sdf::Visual& visual) {
    return visual.Material() ? look_named(visual.Material()->ScriptName()) : std::nullopt;
}

/// Whether a plane is the floor of the world.
bool is_floor(const Isometry3d& T_world_plane) {
    return T_world_plane.linear()(2, 2) > 1.0 - 1e-9 && std::abs(T_world_plane.translation().z()) < 1e-6;
}

/// Pose whose z axis is the normal of a plane.
Isometry3d along_normal(const sdf::Plane& plane, const Isometry3d& T_world_plane) {
    const auto& n = plane.Normal();
    return T_world_plane *
           Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), Vector3d(n.X(), n.Y(), n.Z()));
}

class Conversion {
  public:
    explicit Conversion(LoadedWorld& loaded) : loaded_(loaded) {}

    void model(const sdf::Model& model, const Isometry3d& T_world_parent, const std::string& prefix) {
        const Isometry3d T_world_model = T_world_parent * pose_of(model);
        const std::string name = prefix + model.Name();
        Parts parts;
        for (std::uint64_t i = 0; i < model.LinkCount(); ++i)
            link(*model.LinkByIndex(i), T_world_model, name, parts);
        add_parts(loaded_.world, name,
                  is_ground(name) ? take_ground(loaded_.world, parts) : std::move(parts));
        for (std::uint64_t i = 0; i < model.ModelCount(); ++i)
            this->model(*model.ModelByIndex(i), T_world_model, name + "/");
    }

  private:
    void link(const sdf::Link& link, const Isometry3d& T_world_model, const std::string& name, Parts& parts) {
        const Isometry3d T_world_link = T_world_model * pose_of(link);
        const std::string place = name + "/" + link.Name() + "/";
        for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
            const sdf::Collision& collision = *link.CollisionByIndex(i);
            part(collision, T_world_link, place, nullptr, parts);
        }
        for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
            const sdf::Visual& visual = *link.VisualByIndex(i);
            part(visual, T_world_link, place, &visual, parts);
        }
    }

    template <class Thing>
    void part(const Thing& thing, const Isometry3d& T_world_link, const std::string& place,
              const sdf::Visual* visual, Parts& parts) {
        const std::string name = place + thing.Name();
        const Isometry3d pose = T_world_link * pose_of(thing);
        const sdf::Geometry& geometry = *thing.Geom();
        if (const auto shape = shape_of(geometry)) {
            if (visual) {
                parts.add_visible(*shape, pose, look_of(*visual), name);
            } else {
                parts.add_solid(*shape, pose, name);
            }
        } else if (!geometry.PlaneShape() || !plane(*geometry.PlaneShape(), pose, name, visual)) {
            loaded_.warnings.push_back(name +
                                       ": only boxes, cylinders, spheres and planes that lean by at most 20 "
                                       "degrees are simulated; this shape is left out");
        }
    }

    /// The floor, or a piece of ground; false for planes that no robot can stand on.
    bool plane(const sdf::Plane& plane, const Isometry3d& pose, const std::string& name,
               const sdf::Visual* visual) {
        const Isometry3d T_world_plane = along_normal(plane, pose);
        if (is_floor(T_world_plane)) {
            if (visual) loaded_.world.floor = look_of(*visual).value_or(loaded_.world.floor);
            return true;
        }
        if (!is_walkable(T_world_plane)) return false;
        GroundPiece piece;
        piece.name = model_of(name);
        piece.T_world_ground = T_world_plane;
        piece.size_m = {plane.Size().X(), plane.Size().Y()};
        piece.look =
            visual ? look_of(*visual).value_or(default_ground_look(name)) : default_ground_look(name);
        add_ground(loaded_.world, piece, visual != nullptr);
        return true;
    }

    LoadedWorld& loaded_;
};

void read_frames(const sdf::World& from, LoadedWorld& loaded) {
    for (std::uint64_t i = 0; i < from.FrameCount(); ++i) {
        const sdf::Frame& frame = *from.FrameByIndex(i);
        if (frame.Name() != "start" && frame.Name() != "goal") continue;
        const Isometry3d pose = pose_of(frame);
        const Vector3d& at = pose.translation();
        if (frame.Name() == "start") {
            loaded.world.start = {at.x(), at.y(), std::atan2(pose.linear()(1, 0), pose.linear()(0, 0))};
        } else {
            loaded.world.goal = at.head<2>();
        }
    }
}

}  // namespace

LoadedWorld read_sdf_world(const std::filesystem::path& file) {
    const SdfFile sdf = read_sdf_file(file);
    const sdf::World& from = *sdf.root.WorldByIndex(0);
    LoadedWorld loaded;
    loaded.warnings = sdf.warnings;
    if (sdf.root.WorldCount() > 1) loaded.warnings.emplace_back("only the first world is used");
    try {
        loaded.world.name = from.Name();
        Conversion conversion(loaded);
        for (std::uint64_t i = 0; i < from.ModelCount(); ++i)
            conversion.model(*from.ModelByIndex(i), Isometry3d::Identity(), "");
        read_frames(from, loaded);
        loaded.world.shadow_light = shadow_light_of(from.Element());
        for (const sdf::ElementPtr& actor : sdf.actors) read_actor(actor, loaded);
    } catch (const std::invalid_argument& error) {
        throw WorldError(file.string() + ": " + error.what());
    }
    for (std::string& warning : loaded.warnings) warning.insert(0, file.string() + ": ");
    return loaded;
}

}  // namespace flownav::sim
