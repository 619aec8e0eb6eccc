#pragma once

#include <Eigen/Core>

namespace flownav::mapping {

/// What one set says about one cell. A cell hears of each set once, however many vectors fell into it.
struct Evidence {
    Eigen::Vector2i cell;         ///< floor((position - origin) / edge of a cell)
    double p_free;                ///< MRPT's cells speak of the probability of being FREE
    bool toward_unknown = false;  ///< makes an occupied cell unknown but not free, or the other way round

    bool operator<(const Evidence& o) const {
        if (cell.x() != o.cell.x()) return cell.x() < o.cell.x();
        if (cell.y() != o.cell.y()) return cell.y() < o.cell.y();
        if (toward_unknown != o.toward_unknown) return o.toward_unknown;
        return p_free < o.p_free;  // the surest obstacle first: it wins over floor in the same cell
    }
    /// A doubt whether a cell is free and one whether it is occupied are heard both.
    bool operator==(const Evidence& o) const {
        const bool are_both = toward_unknown && o.toward_unknown && (p_free < 0.5) != (o.p_free < 0.5);
        return cell == o.cell && !are_both;
    }
};

}  // namespace flownav::mapping
