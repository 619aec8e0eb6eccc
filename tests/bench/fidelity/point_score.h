#pragma once
#include <array>
#include <map>
#include <vector>

#include "chain_run.h"
#include "statistics.h"

namespace flownav::fidelity {

/// Horizontal distances of obstacle points to the surfaces of the world, over one or several drives.
struct PointScore {
    Share ghosts;  ///< points far from all surfaces, per cycle with points
    Share near;    ///< points at a surface
    /// Distances to the nearest surface of points at 1-2, 2-3 and 3-4 m.
    std::array<std::vector<double>, 3> surface_error_m;
    Share objects;            ///< share of the objects passed ahead that have at least three points
    Share chairs_in_a_cycle;  ///< share of the chairs in view at 2-4 m that have a point in that cycle

    void add(const PointScore& other);
};

class PointWatcher {
  public:
    void see(const Moment& moment);
    PointScore result() const;

  private:
    void see_points(const Moment& moment);
    void see_objects(const Moment& moment);
    void see_chairs(const Moment& moment);

    PointScore score_;
    std::map<int, int> cycles_in_view_, hits_;  ///< counts per object
};

}  // namespace flownav::fidelity
