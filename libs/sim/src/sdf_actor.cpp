#include "sdf_actor.h"

#include <cmath>
#include <stdexcept>

#include "sdf_look.h"
#include "sdf_parts.h"

namespace flownav::sim {
namespace {

using Eigen::Isometry3d;
using ignition::math::Pose3d;

/// How long a script that starts over and over is followed.
constexpr double repeated_s = 600.0;

/// A person, for actors that are nothing but skin.
const Cylinder person{0.25, 1.75};

Isometry3d pose_of(const sdf::ElementPtr& element) {
    return element->HasElement("pose") ? to_isometry(element->Get<Pose3d>("pose")) : Isometry3d::Identity();
}

std::optional<Shape> shape_of(const sdf::ElementPtr& part) {
    const sdf::ElementPtr geometry = part->GetElement("geometry");
    if (geometry->HasElement("box")) {
        const auto size = geometry->GetElement("box")->Get<ignition::math::Vector3d>("size");
        return checked(Box{{size.X(), size.Y(), size.Z()}});
    }
    if (geometry->HasElement("cylinder")) {
        const sdf::ElementPtr cylinder = geometry->GetElement("cylinder");
        return checked(Cylinder{cylinder->Get<double>("radius"), cylinder->Get<double>("length")});
    }
    if (geometry->HasElement("sphere"))
        return checked(Sphere{geometry->GetElement("sphere")->Get<double>("radius")});
    return std::nullopt;
}

std::optional<Look> look_of(const sdf::ElementPtr& visual) {
    if (!visual->HasElement("material") || !visual->GetElement("material")->HasElement("script"))
        return std::nullopt;
    return look_named(visual->GetElement("material")->GetElement("script")->Get<std::string>("name"));
}

std::vector<TimedPose> one_round(const sdf::ElementPtr& script, const std::string& actor) {
    std::vector<TimedPose> round;
    if (!script->HasElement("trajectory")) return round;
    const sdf::ElementPtr trajectory = script->GetElement("trajectory");
    if (!trajectory->HasElement("waypoint")) return round;
    for (auto point = trajectory->GetElement("waypoint"); point; point = point->GetNextElement("waypoint")) {
        const auto time_s = point->Get<double>("time");
        if (!std::isfinite(time_s) || time_s < 0.0 || (!round.empty() && time_s < round.back().time_s)) {
            throw std::invalid_argument("actor " + actor + ": time " + text_of(time_s) +
                                        " of a waypoint must be >= 0 s and not before the one ahead of it");
        }
        round.push_back({time_s, pose_of(point)});
    }
    return round;
}

/// Poses of an actor over time. At the end of a round it is back at the first waypoint at once, as in Gazebo.
std::vector<TimedPose> timetable(const sdf::ElementPtr& actor, const std::string& name) {
    if (!actor->HasElement("script")) return {};
    const sdf::ElementPtr script = actor->GetElement("script");
    const std::vector<TimedPose> round = one_round(script, name);
    if (round.empty() || !script->Get<bool>("auto_start", true).first)
        return round.empty() ? round : std::vector{round.front()};
    const auto delay_s = script->Get<double>("delay_start", 0.0).first;
    const double round_s = round.back().time_s;
    const bool loop = script->Get<bool>("loop", true).first && round_s > 0.0;
    std::vector<TimedPose> all;
    for (double from_s = delay_s; all.empty() || (loop && from_s < repeated_s); from_s += round_s)
        for (const TimedPose& pose : round) all.push_back({from_s + pose.time_s, pose.T_world_solid});
    return all;
}

Parts parts_of(const sdf::ElementPtr& actor, const std::string& name, std::vector<std::string>& warnings) {
    Parts parts;
    if (!actor->HasElement("link")) {
        Isometry3d standing = Isometry3d::Identity();
        standing.translation().z() = person.length_m / 2;
        parts.add_solid(person, standing, name);
        parts.add_visible(person, standing, std::nullopt, name);
        return parts;
    }
    for (auto link = actor->GetElement("link"); link; link = link->GetNextElement("link")) {
        for (const char* kind : {"collision", "visual"}) {
            if (!link->HasElement(kind)) continue;
            for (auto part = link->GetElement(kind); part; part = part->GetNextElement(kind)) {
                const std::string place = name + "/" + part->Get<std::string>("name");
                const Isometry3d T = pose_of(link) * pose_of(part);
                const auto shape = shape_of(part);
                if (!shape) {
                    warnings.push_back(place + ": only boxes, cylinders and spheres are simulated; left out");
                } else if (part->GetName() == "collision") {
                    parts.add_solid(*shape, T, place);
                } else {
                    parts.add_visible(*shape, T, look_of(part), place);
                }
            }
        }
    }
    return parts;
}

}  // namespace

void read_actor(const sdf::ElementPtr& actor, LoadedWorld& loaded) {
    const auto name = actor->Get<std::string>("name");
    const std::vector<TimedPose> script = timetable(actor, name);
    const Isometry3d T_world_actor = pose_of(actor);
    const std::size_t first = loaded.world.solids.size();
    add_parts(loaded.world, name, parts_of(actor, name, loaded.warnings));
    for (std::size_t i = first; i < loaded.world.solids.size(); ++i) {
        Solid& solid = loaded.world.solids[i];
        for (const TimedPose& pose : script)
            solid.script.push_back({pose.time_s, pose.T_world_solid * solid.T_world_solid});
        solid.T_world_solid = T_world_actor * solid.T_world_solid;
    }
}

}  // namespace flownav::sim
