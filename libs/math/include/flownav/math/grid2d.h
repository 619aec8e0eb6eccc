#pragma once
#include <Eigen/Core>
#include <cstddef>

namespace flownav {

/// Grid of square cells on the ground: cell (0, 0) begins at `origin_m` and is `cell_m` wide along x and y.
struct GridFrame {
    Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
    double cell_m = 0.1;

    /// Cell that contains a point. Rounds down on both sides of the origin. The point must be finite and less
    /// than 2^31 cells away.
    Eigen::Vector2i cell_of(const Eigen::Vector2d& p_m) const {
        return ((p_m - origin_m) / cell_m).array().floor().cast<int>();
    }
    Eigen::Vector2d middle_of(const Eigen::Vector2i& cell) const {
        return origin_m + (cell.cast<double>() + Eigen::Vector2d(0.5, 0.5)) * cell_m;
    }
};

/// A rectangle of cells, stored row by row with x fastest.
struct GridArea : GridFrame {
    int columns = 0;
    int rows = 0;

    bool contains(const Eigen::Vector2i& cell) const {
        return cell.x() >= 0 && cell.y() >= 0 && cell.x() < columns && cell.y() < rows;
    }
    std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
    /// Index of a cell in an array of size() values; the cell must lie in the area.
    std::size_t index(const Eigen::Vector2i& cell) const {
        return static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(cell.x());
    }
    Eigen::Vector2i cell_at(std::size_t index) const {
        return {static_cast<int>(index % static_cast<std::size_t>(columns)),
                static_cast<int>(index / static_cast<std::size_t>(columns))};
    }
};

}  // namespace flownav
