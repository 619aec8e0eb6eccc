#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

#include "flownav/math/grid2d.h"

namespace flownav {

/// Values of square cells on an unbounded plane, for a square window that moves over it. The places form a
/// ring along both axes: cells that are a multiple of side() apart share one, and the cell that claimed it
/// last holds it. Allocates in the constructor only.
template <class Value>
class RollingGrid {
  public:
    /// `side`: edge of the largest window in cells, > 0; a power of two is fastest.
    RollingGrid(const GridFrame& frame, int side)
        : frame_(frame),
          side_(side),
          mask_((side & (side - 1)) == 0 ? side - 1 : -1),
          places_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {}

    const GridFrame& frame() const { return frame_; }
    int side() const { return side_; }

    /// Value of a cell; null when the cell does not hold its place. Valid until clear() or the claim of
    /// another cell.
    const Value* find(const Eigen::Vector2i& cell) const {
        const Place& place = places_[index_of(cell)];
        return place.cell == cell ? &place.value : nullptr;
    }
    Value* find(const Eigen::Vector2i& cell) {
        Place& place = places_[index_of(cell)];
        return place.cell == cell ? &place.value : nullptr;
    }

    /// Value of a cell. A cell that does not hold its place takes it, with the value `fresh`.
    Value& claim(const Eigen::Vector2i& cell, const Value& fresh = Value{}) {
        Place& place = places_[index_of(cell)];
        if (place.cell != cell) place = {cell, fresh};
        return place.value;
    }

    /// Calls visit(cell, value) for every cell that holds a place, in no particular order.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (const Place& place : places_)
            if (place.cell.x() != nowhere) visit(place.cell, place.value);
    }

    /// Removes all cells.
    void clear() { places_.assign(places_.size(), Place{}); }

  private:
    static constexpr int nowhere = std::numeric_limits<int>::min();

    struct Place {
        Eigen::Vector2i cell = Eigen::Vector2i::Constant(nowhere);
        Value value{};
    };

    std::size_t wrapped(int i) const {
        if (mask_ >= 0) return static_cast<std::size_t>(i & mask_);
        const int rest = i % side_;
        return static_cast<std::size_t>(rest < 0 ? rest + side_ : rest);
    }
    std::size_t index_of(const Eigen::Vector2i& cell) const {
        return wrapped(cell.y()) * static_cast<std::size_t>(side_) + wrapped(cell.x());
    }

    GridFrame frame_;
    int side_;
    int mask_;  ///< side - 1 when side is a power of two, else -1
    std::vector<Place> places_;
};

}  // namespace flownav
