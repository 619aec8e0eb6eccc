#include "background.h"

#include <algorithm>

#include "flownav/motion/robust.h"

namespace flownav::motion {
namespace {

constexpr double cluster_share_min = 0.08;

/// Samples first .. last - 1 of a list sorted by omega.
struct Cluster {
    std::size_t first = 0, last = 0;
    double spread = -1.0;
};

double spread_over_image(const std::vector<OmegaSample>& samples, std::size_t first, std::size_t last) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double square = 0.0;
    for (std::size_t i = first; i < last; ++i) {
        sum += samples[i].at;
        square += samples[i].at.squaredNorm();
    }
    const auto n = static_cast<double>(last - first);
    return square / n - (sum / n).squaredNorm();
}

Cluster widest_cluster(const std::vector<OmegaSample>& samples, double gap_rad) {
    Cluster widest{0, samples.size()};
    std::size_t first = 0;
    for (std::size_t i = 1; i <= samples.size(); ++i) {
        if (i < samples.size() && samples[i].omega_rad - samples[i - 1].omega_rad < gap_rad) continue;
        if (static_cast<double>(i - first) >= cluster_share_min * static_cast<double>(samples.size())) {
            const Cluster cluster{first, i, spread_over_image(samples, first, i)};
            if (cluster.spread > widest.spread) widest = cluster;
        }
        first = i;
    }
    return widest;
}

}  // namespace

double background_omega(std::vector<OmegaSample>& samples, double gap_rad, std::vector<double>& values) {
    std::sort(samples.begin(), samples.end(), [](const OmegaSample& p, const OmegaSample& q) {
        if (p.omega_rad != q.omega_rad) return p.omega_rad < q.omega_rad;
        return p.at.x() != q.at.x() ? p.at.x() < q.at.x() : p.at.y() < q.at.y();
    });
    const Cluster background = widest_cluster(samples, gap_rad);
    values.clear();
    for (std::size_t i = background.first; i < background.last; ++i) values.push_back(samples[i].omega_rad);
    // Eq. (6)
    return shorth(values);
}

}  // namespace flownav::motion
