#pragma once
#include <optional>
#include <vector>

#include "flownav/obstacles/floor_comparison.h"
#include "flownav/obstacles/strip_grid.h"

namespace flownav::obstacles {

/// Votes for "an upright surface stands on the floor in this cell": one score a cell of StripGrid.
struct ContactVotes {
    std::vector<float> all;    ///< by all pixels that do not fit
    std::vector<float> steep;  ///< by those on edges nearer to the vertical than to the horizontal

    // Buffers.
    std::vector<int> candidates;  ///< cells, from the farthest to the nearest
    std::vector<float> inverse;   ///< of their forward distances
    std::vector<float> row_weight;
    std::vector<float> shares;
    std::vector<float> votes;  ///< of one strip: cell of the voters times candidate
    std::vector<float> steep_votes;
    std::vector<float> sums;
};

/// Room for images of this height, so that no vote allocates.
void reserve(ContactVotes& votes, std::size_t height);

/// Lets every pixel of `comparison` that does not move as the floor vote for the cells below it: a pixel that
/// moves as an upright surface at that contact votes for it, one that does not votes against it; floor that
/// is seen between contact and pixel votes against it too. `noise`: as in compare_with_floor().
void vote_for_contacts(const LevelImage& reference, const LevelImage& newer, const PairWarp& warp,
                       const FloorComparison& comparison, double noise, const StripRange& strips,
                       ContactVotes& out);

/// How much better the pixels of a strip above a contact at `forward_m` move as floor than as an upright
/// surface that stands there: mean difference of their costs. Weak texture tells, when there are many pixels;
/// a surface without any gives 0. Empty when too few pixels can be compared.
std::optional<double> floor_preference(const LevelImage& reference, const LevelImage& newer,
                                       const PairWarp& warp, const FloorComparison& comparison, double noise,
                                       int strip, double forward_m);

/// Score of a contact in one cell: the sum over three strips of the best of three cells.
float contact_score(const StripGrid& grid, const std::vector<float>& votes, int cell, int strip);

/// The best contact of one strip.
struct Contact {
    double forward_m = 0.0;  ///< middle of the scores above 93 % of the best
    double near_m = 0.0;     ///< their ends
    double far_m = 0.0;
    double score = 0.0;  ///< of three strips and three cells; 0: none
    double own = 0.0;    ///< part of this strip
};

/// The contact with the highest score within the ranges; `strip` is an index of the grid.
Contact best_contact(const LevelImage& newer, const std::vector<float>& votes, int strip, double range_min_m,
                     double range_max_m);

}  // namespace flownav::obstacles
