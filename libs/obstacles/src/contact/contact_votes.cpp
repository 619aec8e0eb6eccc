#include "flownav/obstacles/contact_votes.h"

#include <algorithm>
#include <cmath>

#include "bilinear.h"
#include "strip_grid.h"

namespace flownav::obstacles {
namespace {

constexpr float fit_cost = 1.0F;        // of an upright surface: a pixel with less votes for it
constexpr float against = 0.3F;         // vote of a pixel with more
constexpr float floor_against = 0.1F;   // vote of an informative pixel of floor
constexpr float usual_misfits = 0.15F;  // share of a row above which its votes count less than half
constexpr double contact_nearest_m = 0.5;
constexpr double contact_farthest_m = 5.0;
constexpr double plateau_share = 0.85;

/// Rows in which many strips do not fit weigh little: there the comparison itself is poor.
void weigh_rows(const StripGrid& grid, const std::vector<FloorCell>& cells, ContactVotes& out) {
    out.row_weight.assign(static_cast<std::size_t>(grid.cells), 0.0F);
    for (int cell = 0; cell < grid.cells; ++cell) {
        out.shares.clear();
        for (int s = 0; s < grid.strips; ++s) {
            const FloorCell& c = cells[grid.index(cell, s)];
            if (c.compared > 0)
                out.shares.push_back(static_cast<float>(c.misfits) / static_cast<float>(c.compared));
        }
        if (out.shares.empty()) continue;
        const auto middle = out.shares.begin() + static_cast<std::ptrdiff_t>(out.shares.size() / 2);
        std::nth_element(out.shares.begin(), middle, out.shares.end());
        const float ratio = *middle / usual_misfits;
        out.row_weight[static_cast<std::size_t>(cell)] = 1.0F / (1.0F + ratio * ratio);
    }
}

/// Vote of one pixel for an upright surface of the inverse forward distance `inverse`, 1/m.
class Voter {
  public:
    Voter(const Misfit& pixel, const LevelImage& reference, const PairWarp& warp, float noise)
        : pixel_(pixel), reference_(reference), noise2_(noise * noise) {
        const Eigen::Vector3d at(pixel.u, pixel.v, 1.0);
        x_ = (warp.A * at).cast<float>();
        b_ = (warp.B * warp.forward.dot(at)).cast<float>();
    }

    float vote(float inverse) const {
        const float scale = 1.0F / (x_[2] + b_[2] * inverse);
        const float x = (x_[0] + b_[0] * inverse) * scale;
        const float y = (x_[1] + b_[1] * inverse) * scale;
        if (!can_sample(reference_, x, y)) return 0.0F;
        const float e = pixel_.grey - sample(reference_, x, y);
        const float du = x - pixel_.u;
        const float dv = y - pixel_.v;
        const float tolerance2 = position_error_px * position_error_px +
                                 position_error_per_flow * position_error_per_flow * (du * du + dv * dv);
        const float cost = e * e / (2.0F * (noise2_ + tolerance2 * pixel_.gradient2));
        return cost < fit_cost ? pixel_.cost - cost : -against;
    }

  private:
    const Misfit& pixel_;
    const LevelImage& reference_;
    float noise2_;
    Eigen::Vector3f x_;
    Eigen::Vector3f b_;
};

/// Cells in which a contact may lie.
struct Candidates {
    Candidates(const LevelCamera& camera, const StripGrid& grid) {
        last = grid.cells - 1;
        while (last > 0 && cell_floor_m(camera, last) < contact_nearest_m) --last;
        first = grid.top_row / cell_rows + 1;
        while (first < last && cell_floor_m(camera, first) > contact_farthest_m) ++first;
    }
    int first = 0;
    int last = 0;
};

}  // namespace

void vote_for_contacts(const LevelImage& reference, const LevelImage& newer, const PairWarp& warp,
                       const FloorComparison& comparison, double noise, Voters voters,
                       const StripRange& strips, ContactVotes& out) {
    const StripGrid grid = strip_grid(newer);
    const Candidates candidates(newer.camera, grid);
    const auto cells = static_cast<std::size_t>(grid.cells);
    weigh_rows(grid, comparison.cells, out);
    out.score.assign(grid.size(), 0.0F);
    std::size_t next = 0;
    for (int strip = strips.first; strip < strips.last; ++strip) {
        out.votes.assign(cells * cells, 0.0F);
        while (next < comparison.misfits.size() && comparison.misfits[next].strip < strip) ++next;
        for (; next < comparison.misfits.size() && comparison.misfits[next].strip == strip; ++next) {
            const Misfit& pixel = comparison.misfits[next];
            if (voters == Voters::SteepEdges && !pixel.steep) continue;
            const Voter voter(pixel, reference, warp, static_cast<float>(noise));
            const auto own = static_cast<std::size_t>(pixel.v / cell_rows);
            const float weight = out.row_weight[own];
            for (int c = std::max(candidates.first, static_cast<int>(own)); c <= candidates.last; ++c) {
                const auto inverse = static_cast<float>(1.0 / cell_floor_m(newer.camera, c));
                out.votes[static_cast<std::size_t>(c) * cells + own] += weight * voter.vote(inverse);
            }
        }
        for (int c = candidates.first; c <= candidates.last; ++c) {
            float sum = 0.0F;
            float best = 0.0F;
            for (int from = c; from >= 0; --from) {
                sum += out.votes[static_cast<std::size_t>(c) * cells + static_cast<std::size_t>(from)] -
                       floor_against * comparison.cells[grid.index(from, strip)].floor;
                best = std::max(best, sum);
            }
            out.score[grid.index(c, strip)] = best;
        }
    }
}

Contact best_contact(const LevelImage& newer, const ContactVotes& votes, int strip, double range_min_m,
                     double range_max_m) {
    const StripGrid grid = strip_grid(newer);
    const auto best_near = [&](int cell, int s) {
        float best = 0.0F;
        if (s < 0 || s >= grid.strips) return best;
        for (int c = std::max(0, cell - 1); c <= std::min(grid.cells - 1, cell + 1); ++c)
            best = std::max(best, votes.score[grid.index(c, s)]);
        return best;
    };
    const auto score = [&](int cell) {
        return best_near(cell, strip - 1) + best_near(cell, strip) + best_near(cell, strip + 1);
    };
    const Candidates candidates(newer.camera, grid);
    Contact contact;
    int best = -1;
    for (int c = candidates.first; c <= candidates.last; ++c) {
        const double forward_m = cell_floor_m(newer.camera, c);
        if (forward_m < range_min_m || forward_m > range_max_m || score(c) <= contact.score) continue;
        contact.score = score(c);
        best = c;
    }
    if (best < 0) return contact;
    int near = best;
    int far = best;
    while (near < candidates.last && score(near + 1) > plateau_share * contact.score) ++near;
    while (far > candidates.first && score(far - 1) > plateau_share * contact.score) --far;
    contact.near_m = newer.camera.floor_m(near * cell_rows + cell_rows - 1);
    contact.far_m = newer.camera.floor_m(far * cell_rows);
    const double middle_row = 0.5 * (near + far) * cell_rows + 0.5 * (cell_rows - 1);
    contact.forward_m = newer.camera.floor_m(middle_row);
    contact.own = best_near(best, strip);
    return contact;
}

}  // namespace flownav::obstacles
