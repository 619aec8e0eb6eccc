#pragma once
#include <set>
#include <utility>

#include "chain_run.h"
#include "flownav/mapping/global_map.h"
#include "statistics.h"

namespace flownav::fidelity {

/// The fused map of a drive in the frame of its flow odometry, over one or several drives.
struct MapScore {
    Share precise;  ///< occupied cells within 0.2 m of a surface
    Share found;    ///< surface seen within 4 m (cells of 0.1 m) with an occupied cell within 0.15 m

    void add(const MapScore& other);
};

class MapWatcher {
  public:
    explicit MapWatcher(const mapping::MapParams& params) : map_(params) {}

    void see(const Moment& moment);
    MapScore result(const sim::World& world) const;

  private:
    mapping::GlobalMap map_;
    mapping::ObstacleSet set_;            ///< reused to avoid allocations
    std::set<std::pair<int, int>> seen_;  ///< cells with a surface that was in view
};

}  // namespace flownav::fidelity
