#include "flownav/obstacles/contact_votes.h"

#include <algorithm>
#include <cmath>

#include "bilinear.h"
#include "row_warp.h"

namespace flownav::obstacles {
namespace {

constexpr float floor_against = 0.04F;       // vote of an informative pixel of floor
constexpr float preference_against = 0.06F;  // vote of a pixel, times how much better it fits floor
constexpr float usual_misfits = 0.15F;       // share of a row above which its votes count less than half
constexpr double contact_nearest_m = 0.6;
constexpr double contact_farthest_m = 5.0;
constexpr double highest_m =
    2.0;  // over the floor: what is seen higher is no part of a thing that stands there
constexpr double every_cell_m = 1.4;  // nearer: every second cell is a candidate
constexpr double plateau_share = 0.93;
constexpr double slope_share = 1.3;  // of the distance: votes for one thing decrease over so much
constexpr int preferring_rows = 32;  // above a contact: as many tell whether they are floor
constexpr int preferring_min = 80;   // pixels
constexpr int voters_max = 128;      // of one strip; of more, every second or third votes, with more weight

/// Rows in which many strips do not fit weigh little: there the comparison itself is poor.
void weigh_rows(const StripGrid& grid, const StripRange& strips, const std::vector<FloorCell>& cells,
                ContactVotes& out) {
    out.row_weight.assign(static_cast<std::size_t>(grid.cells), 1.0F);
    for (int cell = grid.top_row / cell_rows; cell < grid.cells; ++cell) {
        out.row_weight[static_cast<std::size_t>(cell)] = 0.0F;
        out.shares.clear();
        for (int s = strips.first; s < strips.last; ++s) {
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

/// Cells in which a contact may lie, from the farthest to the nearest.
void choose_candidates(const LevelCamera& camera, const StripGrid& grid, ContactVotes& out) {
    out.candidates.clear();
    out.inverse.clear();
    bool is_odd = false;
    for (int cell = grid.top_row / cell_rows + 1; cell < grid.cells; ++cell) {
        const double forward_m = cell_floor_m(camera, cell);
        if (forward_m > contact_farthest_m) continue;
        if (forward_m < contact_nearest_m) break;
        is_odd = !is_odd;
        if (forward_m < every_cell_m && is_odd) continue;
        out.candidates.push_back(cell);
        out.inverse.push_back(static_cast<float>(1.0 / forward_m));
    }
}

rows::Vote vote_of(const Misfit& pixel, const PairWarp& warp, double noise, float weight) {
    const Eigen::Vector3d at(pixel.u, pixel.v, 1.0);
    const Eigen::Vector3f x = (warp.A * at).cast<float>();
    const Eigen::Vector3f b = (warp.B * warp.forward.dot(at)).cast<float>();
    const auto sigma = static_cast<float>(noise);
    return {static_cast<float>(pixel.u),
            static_cast<float>(pixel.v),
            pixel.grey,
            pixel.gradient2,
            pixel.cost,
            x[0],
            x[1],
            x[2],
            b[0],
            b[1],
            b[2],
            sigma * sigma,
            weight};
}

/// Misfits begin to end - 1 of one strip.
struct Voters {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// First candidate at which a thing seen in row `v` is not higher than the highest.
std::size_t first_low_enough(const LevelCamera& camera, int v, const std::vector<float>& inverse) {
    const double above_m = highest_m - camera.height_m;
    if (above_m <= 0.0) return inverse.size();
    const double inverse_min = -camera.below_horizon(v) / above_m;
    return static_cast<std::size_t>(std::lower_bound(inverse.begin(), inverse.end(), inverse_min) -
                                    inverse.begin());
}

/// Fills out.votes and out.steep_votes: a row for each cell of voters, a column for each candidate.
void collect_votes(const LevelImage& reference, const LevelImage& newer, const PairWarp& warp,
                   const FloorComparison& comparison, double noise, const Voters& voters, ContactVotes& out) {
    const std::size_t columns = out.candidates.size();
    std::fill(out.votes.begin(), out.votes.end(), 0.0F);
    std::fill(out.steep_votes.begin(), out.steep_votes.end(), 0.0F);
    const std::size_t stride = 1 + (voters.end - voters.begin) / voters_max;
    const int top = strip_grid(newer).top_row / cell_rows;
    std::size_t below = 0;  // first candidate at or below the voter
    for (std::size_t i = voters.begin; i < voters.end; i += stride) {
        const Misfit pixel = misfit_at(comparison, newer, comparison.misfits[i]);
        const int own = pixel.v / cell_rows;
        while (below < columns && out.candidates[below] < own) ++below;
        if (below == columns) break;
        const std::size_t first = own > top ? below : first_low_enough(newer.camera, pixel.v, out.inverse);
        const float weight = static_cast<float>(stride) * out.row_weight[static_cast<std::size_t>(own)];
        std::vector<float>& to = pixel.steep ? out.steep_votes : out.votes;
        rows::functions().vote(rows_reference(reference), vote_of(pixel, warp, noise, weight),
                               out.inverse.data() + first, static_cast<int>(columns - first),
                               to.data() + static_cast<std::size_t>(own) * columns + first);
    }
}

/// Adds up the votes from each candidate upward, less those of the floor that is seen there; the score of the
/// candidate is the largest sum.
void add_up(const StripGrid& grid, const std::vector<FloorCell>& cells, int strip,
            const std::vector<float>& votes, ContactVotes& out, std::vector<float>& score) {
    const std::size_t columns = out.candidates.size();
    out.sums.assign(2 * columns, 0.0F);
    float* const sum = out.sums.data();
    float* const best = sum + columns;
    std::size_t first = columns;
    for (int cell = grid.cells - 1; cell >= 0; --cell) {
        while (first > 0 && out.candidates[first - 1] >= cell) --first;
        const FloorCell& seen = cells[grid.index(cell, strip)];
        const float floor = floor_against * seen.floor + preference_against * std::max(0.0F, seen.preference);
        const float* const row = votes.data() + static_cast<std::size_t>(cell) * columns;
        for (std::size_t c = first; c < columns; ++c) {
            sum[c] += row[c] - floor;
            best[c] = std::max(best[c], sum[c]);
        }
    }
    for (std::size_t c = 0; c < columns; ++c) score[grid.index(out.candidates[c], strip)] = best[c];
}

}  // namespace

void reserve(ContactVotes& votes, std::size_t height) {
    const std::size_t cells = height / cell_rows + 1;
    votes.all.reserve(strips_max * cells);
    votes.steep.reserve(strips_max * cells);
    votes.candidates.reserve(cells);
    votes.inverse.reserve(cells);
    votes.row_weight.reserve(cells);
    votes.shares.reserve(strips_max);
    votes.votes.reserve(cells * cells);
    votes.steep_votes.reserve(cells * cells);
    votes.sums.reserve(2 * cells);
}

void vote_for_contacts(const LevelImage& reference, const LevelImage& newer, const PairWarp& warp,
                       const FloorComparison& comparison, double noise, const StripRange& strips,
                       ContactVotes& out) {
    const StripGrid grid = strip_grid(newer);
    weigh_rows(grid, strips, comparison.cells, out);
    choose_candidates(newer.camera, grid, out);
    out.all.assign(grid.size(), 0.0F);
    out.steep.assign(grid.size(), 0.0F);
    const std::size_t size = static_cast<std::size_t>(grid.cells) * out.candidates.size();
    out.votes.resize(size);
    out.steep_votes.resize(size);
    for (int strip = strips.first; strip < strips.last; ++strip) {
        const auto of_strip = comparison.first_misfit.begin() + strip;
        const Voters voters{of_strip[0], of_strip[1]};
        if (voters.begin == voters.end) continue;
        collect_votes(reference, newer, warp, comparison, noise, voters, out);
        add_up(grid, comparison.cells, strip, out.steep_votes, out, out.steep);
        for (std::size_t i = 0; i < size; ++i) out.votes[i] += out.steep_votes[i];
        add_up(grid, comparison.cells, strip, out.votes, out, out.all);
    }
}

std::optional<double> floor_preference(const LevelImage& reference, const LevelImage& newer,
                                       const PairWarp& warp, const FloorComparison& comparison, double noise,
                                       int strip, double forward_m) {
    const StripGrid grid = strip_grid(newer);
    const int foot = static_cast<int>(newer.camera.row_of(newer.camera.height_m / forward_m));
    const int last = std::min(foot, std::min(newer.height - 1, grid.cells * cell_rows));
    double sum = 0.0;
    int pixels = 0;
    for (int v = std::max(grid.top_row, foot - preferring_rows); v < last; ++v) {
        const int end = std::min(newer.width - 1, strip_column(grid, newer, strip + 1, v));
        for (int u = std::max(1, strip_column(grid, newer, strip, v)); u < end; ++u) {
            const Misfit pixel = misfit_at(comparison, newer, v * newer.width + u);
            const Eigen::Vector3d at(u, v, 1.0);
            const Eigen::Vector3d from = warp.A * at + warp.B * (warp.forward.dot(at) / forward_m);
            const auto x = static_cast<float>(from.x() / from.z());
            const auto y = static_cast<float>(from.y() / from.z());
            const auto i = static_cast<std::size_t>(v * newer.width + u);
            if (std::isnan(comparison.warped[i]) || !can_sample(reference, x, y)) continue;
            const double e = pixel.grey - sample(reference, x, y);
            const double tolerance = rows::position_error_px * rows::position_error_px * pixel.gradient2;
            const double cost = e * e / (2.0 * (noise * noise + tolerance));
            if (std::isnan(cost)) continue;  // beside a place where the camera did not look
            sum += std::min<double>(cost, rows::cost_max) - pixel.cost;
            ++pixels;
        }
    }
    return pixels >= preferring_min ? std::optional<double>(sum / pixels) : std::nullopt;
}

float contact_score(const StripGrid& grid, const std::vector<float>& votes, int cell, int strip) {
    float sum = 0.0F;
    for (int s = std::max(0, strip - 1); s <= std::min(grid.strips - 1, strip + 1); ++s) {
        float best = 0.0F;
        for (int c = std::max(0, cell - 1); c <= std::min(grid.cells - 1, cell + 1); ++c)
            best = std::max(best, votes[grid.index(c, s)]);
        sum += best;
    }
    return sum;
}

Contact best_contact(const LevelImage& newer, const std::vector<float>& votes, int strip, double range_min_m,
                     double range_max_m) {
    const StripGrid grid = strip_grid(newer);
    const auto score = [&](int cell) { return contact_score(grid, votes, cell, strip); };
    const int top = grid.top_row / cell_rows + 1;
    // What stands a little farther away votes here as well.
    const auto is_topped = [&](int cell, double forward_m) {
        for (int c = cell - 1; c >= top && cell_floor_m(newer.camera, c) < slope_share * forward_m; --c)
            if (score(c) > score(cell)) return true;
        return false;
    };
    Contact contact;
    int best = -1;
    for (int c = top; c < grid.cells; ++c) {
        const double forward_m = cell_floor_m(newer.camera, c);
        if (forward_m < range_min_m || forward_m > range_max_m || score(c) <= contact.score) continue;
        if (is_topped(c, forward_m)) continue;
        contact.score = score(c);
        best = c;
    }
    if (best < 0) return contact;
    int near = best;
    int far = best;
    const auto in_plateau = [&](int c) { return score(c) > plateau_share * contact.score; };
    while (near + 1 < grid.cells && in_plateau(near + 1)) ++near;
    // It may as well stand nearer than votes can place it.
    if (cell_floor_m(newer.camera, near) < range_min_m) return {};
    while (far - 1 >= top && in_plateau(far - 1)) --far;
    contact.near_m = newer.camera.floor_m(near * cell_rows + cell_rows - 1);
    contact.far_m = newer.camera.floor_m(far * cell_rows);
    const double middle_row = 0.5 * (near + far) * cell_rows + 0.5 * (cell_rows - 1);
    contact.forward_m = newer.camera.floor_m(middle_row);
    for (int c = std::max(0, best - 1); c <= std::min(grid.cells - 1, best + 1); ++c)
        contact.own = std::max<double>(contact.own, votes[grid.index(c, strip)]);
    return contact;
}

}  // namespace flownav::obstacles
