#pragma once
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include "flownav/core/field.h"
#include "lidar_score.h"

namespace flownav::fidelity {

/// A plan of a drive in the frame of its flow odometry: obstacles of the sensor, and their confirmation by
/// the lidar.
class LidarPlan {
  public:
    void add(const pipeline::Step& step, const LidarView& view);

    /// Writes the plan. Throws std::runtime_error naming a file that cannot be written.
    void write(const std::filesystem::path& svg) const;

  private:
    using Cell = std::pair<int, int>;

    std::map<Cell, int> right_, wrong_;  ///< number of points in a cell
    std::vector<Eigen::Vector2d> path_m_;
};

/// Writes FOLDER/NNNN.png: a camera image with the lidar's obstacles (small) and the points of the sensor
/// (circles; squares for moving ones), coloured by range; points without confirmation by the lidar are
/// crossed.
void write_overlay(const std::filesystem::path& folder, int number, const Field& field,
                   const RayMapper& mapper, const pipeline::Step& step,
                   const std::vector<Eigen::Vector3d>& scan_m, const LidarView& view);

}  // namespace flownav::fidelity
