#include "floor.h"

#include <algorithm>
#include <cmath>

#include "flownav/sim/random.h"

namespace flownav::sim {

using Eigen::Vector2d;

Floor::Floor(const FloorWaves& waves) : plane_(waves.highest_m == 0.0) {
    if (plane_) return;
    constexpr double shortest_m = 0.25;
    constexpr double longest_m = 0.60;
    HashRandom random(waves.seed);
    const auto count = static_cast<double>(waves_.size());
    for (std::size_t i = 0; i < waves_.size(); ++i) {
        const double share = static_cast<double>(i) / (count - 1.0);
        const double length_m = shortest_m + share * (longest_m - shortest_m);
        const double angle = (5.0 * static_cast<double>(i) + random.uniform(0.0, 1.0)) * M_PI / count;
        waves_[i].per_m = Vector2d(std::cos(angle), std::sin(angle)) * (2.0 * M_PI / length_m);
        waves_[i].phase = random.uniform(0.0, 2.0 * M_PI);
        waves_[i].amplitude_m = waves.highest_m / count;
    }
}

double Floor::height_m(const Vector2d& at_m) const {
    if (plane_) return 0.0;
    double sum = 0.0;
    for (const Wave& w : waves_) sum += w.amplitude_m * std::sin(w.per_m.dot(at_m) + w.phase);
    return sum;
}

double Floor::meet(const Ray& ray) const {
    double t = -ray.origin_m.z() / ray.direction.z();
    if (plane_) return t;
    constexpr int newton_steps = 6;
    for (int k = 0; k < newton_steps; ++k) {
        const Vector2d at_m = ray.origin_m.head<2>() + t * ray.direction.head<2>();
        double above_m = ray.origin_m.z() + t * ray.direction.z();
        double sinking = ray.direction.z();
        for (const Wave& w : waves_) {
            const double angle = w.per_m.dot(at_m) + w.phase;
            above_m -= w.amplitude_m * std::sin(angle);
            sinking -= w.amplitude_m * std::cos(angle) * w.per_m.dot(ray.direction.head<2>());
        }
        // Where the ray runs along the slope, the plane's own step is the safe one.
        t -= above_m / std::min(sinking, 0.5 * ray.direction.z());
    }
    return t;
}

}  // namespace flownav::sim
