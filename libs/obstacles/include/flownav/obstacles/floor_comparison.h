#pragma once
#include <cstdint>
#include <vector>

#include "flownav/obstacles/floor_warp.h"
#include "flownav/obstacles/strip_grid.h"

namespace flownav::obstacles {

/// Counts of the pixels of one cell of strip and rows.
struct FloorCell {
    std::uint16_t pixels = 0;
    std::uint16_t edges = 0;     ///< pixels on an edge of any direction
    std::uint16_t compared = 0;  ///< pixels whose place in the reference is known, by the motion of the floor
    std::uint16_t misfits = 0;   ///< of these: not as bright as the floor there was
    std::uint16_t floor = 0;     ///< informative pixels that moved as the floor does
    std::uint16_t not_floor = 0;  ///< informative pixels that did not
    float preference = 0.0F;      ///< sum over the pixels: how much better floor fits than something nearer
};

/// True when a tenth of the pixels of a cell lie on edges.
inline bool has_edge(const FloorCell& cell) {
    return 10 * cell.edges > cell.pixels;
}

/// A pixel that does not move as the floor does, or, above the floor, as what is far away.
struct Misfit {
    int u = 0;
    int v = 0;
    bool steep = false;  ///< on an edge nearer to the vertical than to the horizontal
    float grey = 0.0F;   ///< on the brightness scale of the reference
    float gradient2 = 0.0F;
    float cost = 0.0F;  ///< of the floor, or of what is far away
};

/// Result and memory of compare_with_floor().
struct FloorComparison {
    std::vector<FloorCell> cells;           ///< see StripGrid
    std::vector<int> misfits;               ///< pixels that do not fit, row by row, by strip
    std::vector<std::size_t> first_misfit;  ///< of each strip, and behind the last one
    double gain = 1.0;                      ///< brightness of the newer image over that of the reference
    double vignetting = 0.0;   ///< fall-off of brightness that is left in the images, at the corner
    double noise = 0.0;        ///< standard deviation of differences of grey levels, as measured here
    double fit_share = 0.0;    ///< of the informative pixels of the near floor
    int near_informative = 0;  ///< their number

    // Memory.
    std::vector<float> warped;  ///< grey level that the floor had in the reference; NaN: outside
    std::vector<float>
        offset;  ///< local difference of brightness: a row of tiles is one row, as wide as the image
    struct InStrip {
        int strip;
        int pixel;
    };
    std::vector<InStrip> unsorted;
    std::vector<double> ratios;
    std::vector<float> row_numbers;
    std::vector<float> cost;  ///< of the floor, a pixel an entry
    std::vector<float> steepness2;
    std::vector<unsigned> row_counts;
    std::vector<unsigned> row_evidence;
    std::vector<float> row_nearer;
    std::vector<float> row_preference;
};

/// Room for images of this size, so that no comparison allocates.
void reserve(FloorComparison& comparison, std::size_t width, std::size_t height);

/// Compares every pixel of the strips that could show floor with the place in the reference from which `warp`
/// says the floor came. Above the floor, counts edges and collects the pixels on upright ones that do not
/// move as if far away. `noise`: standard deviation of differences of grey levels.
void compare_with_floor(const LevelImage& reference, const LevelImage& newer, const PairWarp& warp,
                        double noise, const StripRange& strips, FloorComparison& out);

/// After compare_with_floor(): fills FloorCell::preference. Weak texture that no single pixel shows tells in
/// the sum whether it moves as floor or as something a quarter nearer.
void measure_preferences(const LevelImage& reference, const LevelImage& newer, const PairWarp& warp,
                         double noise, FloorComparison& out);

/// Pixel `pixel` of `data.misfits`.
Misfit misfit_at(const FloorComparison& data, const LevelImage& newer, int pixel);

}  // namespace flownav::obstacles
