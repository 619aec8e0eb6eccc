#include <algorithm>
#include <cmath>

#include "flownav/sim/ground.h"
#include "flownav/sim/random.h"
#include "flownav/sim/world_look.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double board_height_m = 0.08;
constexpr double board_out_m = 0.01;
constexpr double mark_thickness_m = 0.001;
constexpr double lamp_every_m = 3.0;
constexpr double lamp_height_m = 2.5;

/// Adds to a world the parts that make it real. Numbers its parts; looks are of one grey.
class Furnisher {
  public:
    Furnisher(World& world, std::uint64_t seed) : world_(world), random_(mix(seed, 1801)) {}

    void furnish() {
        const std::vector<Solid> before = world_.solids;
        bool indoors = false;
        for (Solid& solid : world_.solids)
            if (solid.look.surface != Surface::Lamp) solid.look.surface = Surface::Plain;
        for (const Solid& solid : before) {
            if (!is_wall(solid)) continue;
            indoors = true;
            if (random_.chance(1.0 / 3.0)) add_board(solid);
            if (std::get<Box>(solid.shape).size_m.x() > 1.6 && random_.chance(0.35)) add_door(solid);
        }
        world_.shadow_light = indoors ? lamp_light() : sun();
        if (!indoors) return;
        const Eigen::AlignedBox2d area = extent(before);
        add_marks(area);
        add_lamps(area);
    }

  private:
    static bool is_wall(const Solid& solid) {
        return solid.name.rfind("wall", 0) == 0 && std::holds_alternative<Box>(solid.shape);
    }

    static Eigen::AlignedBox2d extent(const std::vector<Solid>& solids) {
        Eigen::AlignedBox2d box;
        for (const Solid& solid : solids) box.extend(Vector2d(solid.T_world_solid.translation().head<2>()));
        return box;
    }

    Look plain(double low_grey, double high_grey) {
        return {Surface::Plain, std::round(random_.uniform(low_grey, high_grey)), 0};
    }

    /// A grey that differs from another by 25 to 60.
    Look contrast(double grey) {
        const double off = random_.uniform(25.0, 60.0);
        return {Surface::Plain, std::round(grey > 110.0 ? grey - off : grey + off), 0};
    }

    void add(const std::string& name, const Vector3d& size_m, const Eigen::Isometry3d& pose, const Look& look,
             bool solid) {
        Solid part;
        part.name = name + "_" + std::to_string(++count_);
        part.shape = Box{size_m};
        part.T_world_solid = pose;
        part.look = look;
        part.solid = solid;
        world_.solids.push_back(part);
    }

    /// Around the foot of a wall, on both sides.
    void add_board(const Solid& wall) {
        const Vector3d size = std::get<Box>(wall.shape).size_m;
        const double down_m = (size.z() - board_height_m) / 2;
        add("skirting", {size.x(), size.y() + 2 * board_out_m, board_height_m},
            wall.T_world_solid * Eigen::Translation3d(0.0, 0.0, -down_m), contrast(wall.look.grey), true);
    }

    /// A closed door on one side of a wall: a leaf, two jambs and a lintel.
    void add_door(const Solid& wall) {
        constexpr double leaf_m = 0.9;
        constexpr double high_m = 2.0;
        constexpr double frame_m = 0.07;
        const Vector3d size = std::get<Box>(wall.shape).size_m;
        const double side = random_.chance(0.5) ? 1.0 : -1.0;
        const double half_m = size.x() / 2 - 0.7;
        const double at_m = random_.uniform(-half_m, half_m);
        const auto place = [&](double along_m, double out_m, double up_m) {
            return Eigen::Isometry3d(wall.T_world_solid * Eigen::Translation3d(at_m + along_m,
                                                                               side * (size.y() / 2 + out_m),
                                                                               up_m - size.z() / 2));
        };
        const Look leaf = contrast(wall.look.grey);
        const Look frame = contrast(leaf.grey);
        add("door", {leaf_m, 0.02, high_m}, place(0.0, 0.005, high_m / 2), leaf, true);
        for (const double end : {-1.0, 1.0})
            add("jamb", {frame_m, 0.04, high_m}, place(end * (leaf_m + frame_m) / 2, 0.01, high_m / 2), frame,
                true);
        add("lintel", {leaf_m + 2 * frame_m, 0.04, frame_m}, place(0.0, 0.01, high_m + frame_m / 2), frame,
            true);
    }

    /// Whether a rectangle lies on the bare floor with all corners.
    bool lies_on_floor(const Pose2& at, const Vector2d& size_m) const {
        const Vector2d middle(at.x_m, at.y_m);
        for (const double x : {-0.5, 0.5}) {
            for (const double y : {-0.5, 0.5}) {
                const Vector2d corner = transform(at, Vector2d(x * size_m.x(), y * size_m.y()));
                if (ground_height_m(world_, corner) != 0.0 || ground_steps_m(world_, middle, corner) != 0.0)
                    return false;
            }
        }
        return ground_height_m(world_, middle) == 0.0;
    }

    /// Left out when no place for it is found.
    void add_mark(const std::string& name, const Eigen::AlignedBox2d& area, const Vector2d& size_m,
                  const Look& look) {
        constexpr int attempts = 20;
        for (int i = 0; i < attempts; ++i) {
            const double x_m = random_.uniform(area.min().x(), area.max().x());
            const double y_m = random_.uniform(area.min().y(), area.max().y());
            const Pose2 at{x_m, y_m, random_.uniform(-M_PI, M_PI)};
            if (!lies_on_floor(at, size_m)) continue;
            Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
            pose.translate(Vector3d(x_m, y_m, mark_thickness_m / 2));
            pose.rotate(Eigen::AngleAxisd(at.yaw_rad, Vector3d::UnitZ()));
            return add(name, {size_m.x(), size_m.y(), mark_thickness_m}, pose, look, false);
        }
    }

    void add_marks(const Eigen::AlignedBox2d& area) {
        for (int i = random_.integer(3, 6); i > 0; --i)
            add_mark("tape", area, {random_.uniform(0.6, 2.5), 0.05}, contrast(world_.floor.grey));
        for (int i = random_.integer(2, 4); i > 0; --i)
            add_mark("paper", area, {0.297, 0.21}, plain(190, 215));
        for (int i = random_.integer(1, 3); i > 0; --i) {
            const Vector2d size(random_.uniform(0.6, 1.2), random_.uniform(0.4, 0.8));
            add_mark("mat", area, size, contrast(world_.floor.grey));
        }
    }

    void add_lamps(const Eigen::AlignedBox2d& area) {
        const Vector2d first = area.min() + Vector2d(random_.uniform(0.5, 2.0), random_.uniform(0.5, 2.0));
        for (double x_m = first.x(); x_m < area.max().x(); x_m += lamp_every_m) {
            for (double y_m = first.y(); y_m < area.max().y(); y_m += lamp_every_m) {
                Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
                pose.translate(Vector3d(x_m, y_m, lamp_height_m));
                add("lamp", {0.4, 0.4, 0.05}, pose, {Surface::Lamp, 250.0, 0}, false);
            }
        }
    }

    ShadowLight light(double flattest, double loss_low, double loss_high, double soft_low_m,
                      double soft_high_m) {
        ShadowLight light;
        const double turn_rad = random_.uniform(-M_PI, M_PI);
        const double slant = random_.uniform(0.1, flattest);
        light.towards = {slant * std::cos(turn_rad), slant * std::sin(turn_rad), 1.0};
        light.loss = random_.uniform(loss_low, loss_high);
        light.soft_m = random_.uniform(soft_low_m, soft_high_m);
        return light;
    }

    ShadowLight lamp_light() { return light(0.35, 0.2, 0.4, 0.05, 0.25); }
    ShadowLight sun() { return light(0.8, 0.35, 0.5, 0.01, 0.03); }

    World& world_;
    Random random_;
    int count_ = 0;
};

}  // namespace

void furnish_as_real(World& world, std::uint64_t seed) {
    Furnisher(world, seed).furnish();
}

}  // namespace flownav::sim
