#include "tables.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "flownav/sim/surface_texture.h"

namespace flownav::testing {
namespace {

template <typename... Values>
std::string line(const char* format, Values... values) {
    std::array<char, 512> text{};
    std::snprintf(text.data(), text.size(), format, values...);  // NOLINT(*-vararg)
    return text.data();
}

void write_text(const std::string& text, const std::filesystem::path& file) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace

std::filesystem::path with_suffix(const std::filesystem::path& basename, const std::string& suffix) {
    return basename.string() + suffix;
}

void write_ground_truth_csv(const Scene& scene, const std::filesystem::path& file) {
    std::string text = "i,t,x,y,phi,omega_radps,v_mps\n";
    for (int i = 0; i < scene.images(); ++i) {
        const Pose2& pose = scene.poses[static_cast<std::size_t>(i)];
        text += line("%d,%.4f,%.7f,%.7f,%.7f,", i, scene.time_s(i), pose.x_m, pose.y_m, pose.yaw_rad);
        if (i == 0) {
            text += "nan,nan\n";
            continue;
        }
        const EgoMotion motion = exact_motion(scene.poses[static_cast<std::size_t>(i) - 1], pose);
        const double rate_hz = scene.options.rate_hz;
        text += line("%.7f,%.7f\n", motion.omega_rad * rate_hz, motion.forward_m * rate_hz);
    }
    write_text(text, file);
}

void write_objects_csv(const Scene& scene, const std::filesystem::path& file) {
    std::string text =
        "type(0,\"box,1\",cylinder),cx,cy,z0,z1,half_x_or_radius,half_y,cos_yaw,sin_yaw,texture,shade,"
        "group\n";
    for (const Solid& solid : scene.world.solids) {
        const Upright u = upright_of(solid);
        const Look& look = solid.look;
        text += line("%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f\n",
                     static_cast<double>(u.shape), u.centre_m.x(), u.centre_m.y(), u.z_low_m, u.z_high_m,
                     u.half_x_m, u.half_y_m, std::cos(u.yaw_rad), std::sin(u.yaw_rad),
                     static_cast<double>(look.surface), look.grey / sim::usual_grey(look.surface),
                     static_cast<double>(solid.object));
    }
    write_text(text, file);
}

void write_movers_csv(const Scene& scene, const std::filesystem::path& file) {
    if (scene.world.solids.empty() || scene.world.solids.back().script.empty()) return;
    std::string text = "x,y of the last object per frame\n";
    for (int i = 0; i < scene.images(); ++i) {
        const Eigen::Vector3d at_m = pose_at(scene.world.solids.back(), scene.time_s(i)).translation();
        text += line("%.7f,%.7f\n", at_m.x(), at_m.y());
    }
    write_text(text, file);
}

}  // namespace flownav::testing
