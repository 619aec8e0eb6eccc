#include <cmath>
#include <sstream>

#include "flownav/sim/sdf_world.h"
#include "sdf_look.h"

namespace flownav::sim {
namespace {

using Eigen::Isometry3d;

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&') {
            out += "&amp;";
        } else if (c == '<') {
            out += "&lt;";
        } else if (c == '>') {
            out += "&gt;";
        } else if (c == '"') {
            out += "&quot;";
        } else {
            out += c;
        }
    }
    return out;
}

/// To 1e-9 m or rad: what is read and written again then stays the same to the letter.
std::string numbers(std::initializer_list<double> values) {
    std::string text;
    for (const double value : values)
        text += (text.empty() ? "" : " ") + text_of(std::round(value * 1e9) / 1e9);
    return text;
}

/// x y z roll pitch yaw, as SDF has it.
std::string pose_text(const Isometry3d& T) {
    const Eigen::Matrix3d R = T.linear();
    const double roll_rad = std::atan2(R(2, 1), R(2, 2));
    const double pitch_rad = std::atan2(-R(2, 0), std::hypot(R(2, 1), R(2, 2)));
    const double yaw_rad = std::atan2(R(1, 0), R(0, 0));
    const auto& t = T.translation();
    return numbers({t.x(), t.y(), t.z(), roll_rad, pitch_rad, yaw_rad});
}

std::string shape_text(const Shape& shape) {
    if (const auto* box = std::get_if<Box>(&shape)) {
        const auto& size = box->size_m;
        return "<box><size>" + numbers({size.x(), size.y(), size.z()}) + "</size></box>";
    }
    if (const auto* c = std::get_if<Cylinder>(&shape)) {
        return "<cylinder><radius>" + text_of(c->radius_m) + "</radius><length>" + text_of(c->length_m) +
               "</length></cylinder>";
    }
    return "<sphere><radius>" + text_of(std::get<Sphere>(shape).radius_m) + "</radius></sphere>";
}

std::string material(const Look& look) {
    return "<material><script><uri>flownav</uri><name>" + name_of(look) + "</name></script></material>";
}

std::string link(const Solid& solid) {
    const std::string geometry = "<geometry>" + shape_text(solid.shape) + "</geometry>";
    std::string text = "      <link name=\"link\">\n";
    if (solid.solid) text += "        <collision name=\"collision\">" + geometry + "</collision>\n";
    if (solid.visible)
        text += "        <visual name=\"visual\">" + geometry + material(solid.look) + "</visual>\n";
    return text + "      </link>\n";
}

std::string model(const Solid& solid) {
    return "    <model name=\"" + escaped(solid.name) + "\">\n      <static>true</static>\n      <pose>" +
           pose_text(solid.T_world_solid) + "</pose>\n" + link(solid) + "    </model>\n";
}

std::string actor(const Solid& solid) {
    std::ostringstream text;
    text << "    <actor name=\"" << escaped(solid.name) << "\">\n      <pose>"
         << pose_text(solid.T_world_solid) << "</pose>\n"
         << link(solid) << "      <script>\n        <loop>false</loop>\n"
         << "        <trajectory id=\"0\" type=\"path\">\n";
    for (const TimedPose& pose : solid.script) {
        text << "          <waypoint><time>" << text_of(pose.time_s) << "</time><pose>"
             << pose_text(pose.T_world_solid) << "</pose></waypoint>\n";
    }
    text << "        </trajectory>\n      </script>\n    </actor>\n";
    return text.str();
}

std::string frame(const std::string& name, const Pose2& pose) {
    return "    <frame name=\"" + name + "\"><pose>" +
           numbers({pose.x_m, pose.y_m, 0.0, 0.0, 0.0, pose.yaw_rad}) + "</pose></frame>\n";
}

/// A model that is a plane; `pose` is its element with its line, or empty at the origin.
std::string plane_model(const std::string& name, const std::string& pose, const std::string& size,
                        const Look& look) {
    const std::string plane =
        "<geometry><plane><normal>0 0 1</normal><size>" + size + "</size></plane></geometry>";
    return "    <model name=\"" + escaped(name) + "\">\n      <static>true</static>\n" + pose +
           "      <link name=\"link\">\n"
           "        <collision name=\"collision\">" +
           plane +
           "</collision>\n"
           "        <visual name=\"visual\">" +
           plane + material(look) +
           "</visual>\n"
           "      </link>\n    </model>\n";
}

std::string ground(const GroundPiece& piece) {
    return plane_model(piece.name, "      <pose>" + pose_text(piece.T_world_ground) + "</pose>\n",
                       numbers({piece.size_m.x(), piece.size_m.y()}), piece.look);
}

std::string shadows(const ShadowLight& light) {
    const auto& to = light.towards;
    return "    <flownav:shadows>" + numbers({to.x(), to.y(), to.z(), light.loss, light.soft_m}) +
           "</flownav:shadows>\n";
}

}  // namespace

std::string to_sdf(const World& world) {
    std::string text = "<?xml version=\"1.0\"?>\n<sdf version=\"1.9\">\n  <world name=\"" +
                       escaped(world.name.empty() ? "unnamed" : world.name) + "\">\n";
    if (world.shadow_light) text += shadows(*world.shadow_light);
    text += plane_model("floor", "", "100 100", world.floor);
    for (const GroundPiece& piece : world.ground) text += ground(piece);
    text += frame("start", world.start);
    if (world.goal) text += frame("goal", {world.goal->x(), world.goal->y(), 0.0});
    for (const Solid& solid : world.solids) text += solid.script.empty() ? model(solid) : actor(solid);
    return text + "  </world>\n</sdf>\n";
}

}  // namespace flownav::sim
