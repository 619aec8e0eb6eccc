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

constexpr double obstacle_low_m = 0.3;   ///< height above the road
constexpr double obstacle_high_m = 2.0;  ///< higher returns need not be found
constexpr double lidar_cell_m = 0.5;
constexpr double lately_s = 1.0;
constexpr std::array<double, 3> lidar_range_ends_m = {10.0, 15.0, 25.0};

/// Largest distance at which a point or a cell counts as confirmed.
inline double tolerance_m(double range_m) {
    return 0.5 + 0.05 * range_m;
}

/// Content of a block according to the lidar.
enum class Looks { AtRoad, AtObstacle, Elsewhere };

/// Labels of the blocks with one kind of content.
struct Labels {
    std::map<BlockLabel, int> all;
    std::map<BlockLabel, int> telling;  ///< of blocks whose true value of (13) exceeds tau by half a pixel
    std::map<BlockLabel, int> beyond;   ///< of blocks whose true flow lies outside the search window
};

/// Obstacle points against a lidar, over the cycles in which the car moved.
struct LidarScore {
    Share points_near;  ///< points with a return above obstacle_low_m near them
    /// Control: points_near for the points moved half as far again, which counts random matches.
    Share control_near;
    Share moving_near;  ///< points labelled as moving with a return above obstacle_low_m near them
    std::array<Share, lidar_range_ends_m.size()> near_by_range, found_by_range;
    Share cells_found;   ///< cells with obstacles in the covered area that have a point near them
    Share cells_lately;  ///< cells_found with the points of the last second
    Share things_found;  ///< groups of at least 4 connected cells with a point near one of them
    Share things_lately;
    std::map<Looks, Labels> labels;
    int cycles = 0;
};

/// Obstacles seen by the lidar at one moment, in the robot frame.
struct LidarView {
    std::vector<Eigen::Vector2d> high_m;   ///< all returns above obstacle_low_m
    std::vector<Eigen::Vector2d> cells_m;  ///< centres of cells with obstacles in the covered area
};

/// Converts a scan; the blocks of `layout` define the covered area.
LidarView lidar_view(const std::vector<Eigen::Vector3d>& scan_m, const RayMapper& mapper,
                     const flow::BlockLayout& layout, double range_max_m);

/// Distance to the nearest of `places_m`; infinite without places.
double nearest_m(const std::vector<Eigen::Vector2d>& places_m, const Eigen::Vector2d& at_m);

/// Evaluates the cycles of a drive, one after the other.
class LidarJudge {
  public:
    LidarJudge(const CameraModel& camera, const config::Config& config);

    /// `step` must end a cycle; the scans are those of its last field and its reference.
    void see(const pipeline::Step& step, const std::vector<Eigen::Vector3d>& scan_m,
             const std::vector<Eigen::Vector3d>& reference_scan_m);

    const LidarScore& result() const { return score_; }
    const LidarView& view() const { return view_; }  ///< view of the last cycle
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
