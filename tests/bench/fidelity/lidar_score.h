#pragma once
#include <array>
#include <deque>
#include <map>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/flow/block_layout.h"
#include "flownav/pipeline/step.h"
#include "kitti_lidar.h"
#include "statistics.h"

namespace flownav::fidelity {

constexpr double obstacle_low_m = 0.3;   ///< above the road
constexpr double obstacle_high_m = 2.0;  ///< what is higher need not be found
constexpr double lidar_cell_m = 0.5;
constexpr double lately_s = 1.0;
constexpr std::array<double, 3> lidar_range_ends_m = {10.0, 15.0, 25.0};

/// A point or a cell is at the right place when it is no farther off than this.
inline double tolerance_m(double range_m) {
    return 0.5 + 0.05 * range_m;
}

/// What a block looks at, by the lidar.
enum class Looks { AtRoad, AtObstacle, Elsewhere };

/// What became of blocks that look at one kind of thing.
struct Labels {
    std::map<BlockLabel, int> all;
    std::map<BlockLabel, int> telling;  ///< of those whose true value of (13) exceeds tau by half a pixel
    std::map<BlockLabel, int> beyond;   ///< of those whose true flow lies outside the search window
};

/// Obstacle points against a lidar, over the cycles of a drive that moved the car.
struct LidarScore {
    Share points_near;   ///< points with a return above obstacle_low_m near them
    Share control_near;  ///< the same points moved half as far again: what chance would confirm
    Share moving_near;   ///< those of them that are said to move
    std::array<Share, lidar_range_ends_m.size()> near_by_range, found_by_range;
    Share cells_found;   ///< cells with obstacles in the covered area that have a point near them
    Share cells_lately;  ///< the same, with the points of the last second
    Share things_found;  ///< connected cells, 4 at least, with a point near one of them
    Share things_lately;
    std::map<Looks, Labels> labels;
    int cycles = 0;
};

/// What the lidar sees of obstacles at one moment, in the robot frame.
struct LidarView {
    std::vector<Eigen::Vector2d> high_m;   ///< all returns above obstacle_low_m
    std::vector<Eigen::Vector2d> cells_m;  ///< cells of obstacles in the covered area, their middles
};

/// `layout`: what it covers is the area that is looked at.
LidarView lidar_view(const std::vector<Eigen::Vector3d>& scan_m, const RayMapper& mapper,
                     const flow::BlockLayout& layout, double range_max_m);

/// Distance to the nearest of some places; infinite when there is none.
double nearest_m(const std::vector<Eigen::Vector2d>& places_m, const Eigen::Vector2d& at_m);

/// Enters the cycles of a drive, one after the other.
class LidarJudge {
  public:
    LidarJudge(const CameraModel& camera, const config::Config& config);

    /// `step` ended a cycle; the scans belong to its last field and to its reference.
    void see(const pipeline::Step& step, const std::vector<Eigen::Vector3d>& scan_m,
             const std::vector<Eigen::Vector3d>& reference_scan_m);

    const LidarScore& result() const { return score_; }
    const LidarView& view() const { return view_; }  ///< of the last cycle
    const RayMapper& mapper() const { return mapper_; }

  private:
    struct Moment {
        double timestamp_s = 0.0;
        Pose2 T_start_robot;
        std::vector<Eigen::Vector2d> points_m;  ///< robot frame
    };

    std::vector<Eigen::Vector2d> points_lately(const pipeline::Step& step);
    void see_points(const pipeline::Step& step);
    void see_cells(const std::vector<Eigen::Vector2d>& now_m, const std::vector<Eigen::Vector2d>& lately_m);
    void see_blocks(const pipeline::Step& step, const std::vector<Eigen::Vector3d>& scan_m);

    RayMapper mapper_;
    config::Config config_;
    flow::BlockLayout layout_;
    LidarView view_;
    std::deque<Moment> moments_;
    LidarScore score_;
};

}  // namespace flownav::fidelity
