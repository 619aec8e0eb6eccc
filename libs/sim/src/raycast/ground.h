#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "floor.h"
#include "flownav/sim/world.h"

namespace flownav::sim {

/// A piece of ground seen from above: its top is the plane z = height_m + slope . (x, y).
struct PlanPiece {
    std::array<Eigen::Vector2d, 4> corners_m;  ///< counter-clockwise; side k leads from corner k to the next
    double height_m = 0.0;
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();

    double height_at_m(const Eigen::Vector2d& at_m) const { return height_m + slope.dot(at_m); }
};

/// Stretch of a line from + t * along that lies within a piece, and the sides through which it enters and
/// leaves.
struct PieceStretch {
    double enter = 0.0;
    double leave = 0.0;
    int enter_side = 0;
    int leave_side = 0;
};

PlanPiece plan_of(const GroundPiece& piece);

/// Empty when the line misses the piece, or runs along one of its sides outside.
std::optional<PieceStretch> stretch_in(const PlanPiece& piece, const Eigen::Vector2d& from_m,
                                       const Eigen::Vector2d& along);

constexpr int bare_floor = -1;

struct GroundHit {
    double t = std::numeric_limits<double>::infinity();
    int piece = bare_floor;
    int side = -1;       ///< of the piece, when the ray meets a wall
    bool inner = false;  ///< the wall faces the inside of the piece
};

/// The ground of a world: its floor, and the pieces that cover or open it.
class Ground {
  public:
    explicit Ground(const World& world);

    double height_m(const Eigen::Vector2d& at_m) const;
    double steps_m(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const;

    /// First ground that a ray meets which begins above it; t is infinite when it meets none.
    GroundHit meet(const Ray& ray) const;

    const std::vector<PlanPiece>& pieces() const { return pieces_; }

    /// The highest piece at a place, or bare_floor.
    int piece_at(const Eigen::Vector2d& at_m) const;

  private:
    struct Crossing {
        double t = 0.0;
        int piece = 0;
        int side = 0;
        bool enters = false;
    };
    using Cover = std::vector<int>;

    std::vector<Crossing> crossings(const Eigen::Vector2d& from_m, const Eigen::Vector2d& along, double first,
                                    Cover& cover) const;
    double height_m(const Cover& cover, const Eigen::Vector2d& at_m) const;
    GroundHit meet_top(const Cover& cover, const Ray& ray, double from_t, double to_t) const;
    GroundHit wall_of(const Cover& cover, const Eigen::Vector2d& at_m, const Crossing* first,
                      const Crossing* last) const;

    Floor floor_;
    std::vector<PlanPiece> pieces_;
};

}  // namespace flownav::sim
