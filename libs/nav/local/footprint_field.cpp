#include "flownav/nav/footprint_field.h"

#include <cmath>

namespace flownav::nav {

using Eigen::Vector2d;

FootprintField::FootprintField(const Polygon& footprint_m, double reach_m)
    : reach_m_(reach_m), radius_m_(circumscribed_radius_m(footprint_m) + reach_m) {
    low_m_ = footprint_m.front();
    Vector2d high_m = low_m_;
    for (const Vector2d& corner : footprint_m) {
        low_m_ = low_m_.cwiseMin(corner);
        high_m = high_m.cwiseMax(corner);
    }
    low_m_ -= Vector2d::Constant(reach_m);
    high_m += Vector2d::Constant(reach_m);
    columns_ = static_cast<int>(std::ceil((high_m.x() - low_m_.x()) / step_m)) + 2;
    rows_ = static_cast<int>(std::ceil((high_m.y() - low_m_.y()) / step_m)) + 2;
    distance_m_.reserve(static_cast<std::size_t>(columns_) * rows_);
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
            const Vector2d p = low_m_ + step_m * Vector2d(column, row);
            distance_m_.push_back(static_cast<float>(signed_distance_m(footprint_m, p)));
        }
    }
}

}  // namespace flownav::nav
