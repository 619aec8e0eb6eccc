#include "flownav/obstacles/virtual_scan.h"

#include <algorithm>
#include <cmath>

#include "flownav/core/plane_geometry.h"
#include "flownav/math/units.h"

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;

constexpr double floor_gap_m = 0.5;

double bearing_of(const Vector2d& p) {
    return std::atan2(p.y(), p.x());
}

int beam_of(const VirtualScan& scan, double bearing_rad) {
    const double i = std::floor((bearing_rad - scan.first_bearing_rad) / scan.step_rad + 0.5);
    return i >= 0 && i < static_cast<double>(scan.beams.size()) ? static_cast<int>(i) : -1;
}

/// Extends a free beam by floor from near_m to far_m when the gap between them is at most floor_gap_m; makes
/// an unknown beam free; leaves beams that end at an obstacle.
void extend_by_floor(Beam& beam, double near_m, double far_m) {
    if (beam.kind == BeamKind::Obstacle) return;
    if (beam.kind == BeamKind::Unknown) {
        beam = {BeamKind::Free, far_m};
    } else if (near_m <= beam.range_m + floor_gap_m) {
        beam.range_m = std::max(beam.range_m, far_m);
    }
}

}  // namespace

VirtualScan scan_layout(const RayMapper& mapper, const ObstacleParams& params) {
    const CameraModel& c = mapper.camera();
    const PlaneGeometry plane(c.mount);
    double widest_rad = 0.0;
    for (const double u : {0.0, c.width_px - 1.0}) {
        for (const double v : {0.0, c.height_px - 1.0}) {
            const Vector2d at = mapper.ray({u, v});
            widest_rad = std::max(widest_rad, std::abs(std::atan2(at.x(), plane.a - plane.b * at.y())));
        }
    }
    VirtualScan scan;
    scan.step_rad = params.beam_deg * degree_rad;
    const int half = std::max(1, static_cast<int>(std::ceil(widest_rad / scan.step_rad)));
    scan.first_bearing_rad = -half * scan.step_rad;
    scan.beams.resize(2 * half + 1);
    return scan;
}

void fill_scan(VirtualScan& scan, const std::vector<ObstaclePoint>& points,
               std::vector<GroundPatch>& patches) {
    std::fill(scan.beams.begin(), scan.beams.end(), Beam{});
    for (const ObstaclePoint& point : points) {
        const Vector2d p = point.position_m.head<2>();
        const int i = beam_of(scan, bearing_of(p));
        if (i < 0) continue;
        Beam& beam = scan.beams[i];
        const double range_m = p.norm();
        if (beam.kind != BeamKind::Obstacle || range_m < beam.range_m)
            beam = {BeamKind::Obstacle, range_m, BeamCause::Blocks, range_m - point.sigma_m,
                    range_m + point.sigma_m};
    }
    std::sort(patches.begin(), patches.end(), [](const GroundPatch& p, const GroundPatch& q) {
        return p.near_m.squaredNorm() < q.near_m.squaredNorm();
    });
    for (const GroundPatch& patch : patches) {
        const int i = beam_of(scan, bearing_of((patch.near_m + patch.far_m) / 2));
        if (i >= 0) extend_by_floor(scan.beams[i], patch.near_m.norm(), patch.far_m.norm());
    }
}

void add_contacts(VirtualScan& scan, const ContactScan& contacts) {
    if (contacts.gate != ContactGate::Open) return;
    for (int i = 0; i < static_cast<int>(contacts.strips.size()); ++i) {
        const ContactStrip& strip = contacts.strips[static_cast<std::size_t>(i)];
        if (strip.kind == BeamKind::Unknown) continue;
        const bool is_obstacle = strip.kind == BeamKind::Obstacle;
        const double forward_m = is_obstacle ? strip.contact_m : strip.free_m;
        const auto bearing_at = [&](double share) {
            const double right = (contacts.first + i + share) * contacts.step;
            return bearing_of(point_of(contacts, right, forward_m));
        };
        const double range_m = point_of(contacts, middle_tangent(contacts, i), forward_m).norm();
        const double per_forward = range_m / forward_m;
        const double left_rad = bearing_at(0.0);
        const double right_rad = bearing_at(1.0);
        for (int k = std::max(0, beam_of(scan, right_rad)); k < static_cast<int>(scan.beams.size()); ++k) {
            const double bearing_rad = scan.first_bearing_rad + k * scan.step_rad;
            if (bearing_rad + scan.step_rad / 2 <= right_rad) continue;
            if (bearing_rad - scan.step_rad / 2 >= left_rad) break;
            Beam& beam = scan.beams[static_cast<std::size_t>(k)];
            if (!is_obstacle) {
                extend_by_floor(beam, 0.0, range_m);
            } else if (beam.kind != BeamKind::Obstacle || range_m < beam.range_m) {
                beam = {BeamKind::Obstacle, range_m, strip.cause, per_forward * strip.near_m,
                        per_forward * strip.far_m};
            }
        }
    }
}

}  // namespace flownav::obstacles
