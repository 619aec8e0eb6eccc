#pragma once

#include <Eigen/Core>

namespace flownav::mapping {

/// What one set says about one cell. A cell hears of each set once, however many vectors fell into it.
struct Evidence {
    Eigen::Vector2i cell;          ///< floor((position - origin) / edge of a cell)
    double p_free;                 ///< MRPT's cells speak of the probability of being FREE
    bool at_most_unknown = false;  ///< makes an occupied cell unknown, and no cell free

    bool operator<(const Evidence& o) const {
        if (cell.x() != o.cell.x()) return cell.x() < o.cell.x();
        if (cell.y() != o.cell.y()) return cell.y() < o.cell.y();
        return p_free < o.p_free;  // the surest obstacle first: it wins over floor in the same cell
    }
    bool operator==(const Evidence& o) const { return cell == o.cell; }
};

}  // namespace flownav::mapping
