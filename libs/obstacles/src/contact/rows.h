#pragma once

// The loops of the contact scan over pixels, compiled for several instruction sets: one result on every
// processor, because no loop reorders a sum and no product is fused with a sum. Plain types only: what this
// file includes is compiled with instructions that the processor may not have.
namespace flownav::obstacles::rows {

/// Where the pixels u of one row were in the reference: (x0 + x1 u, y0 + y1 u) / (z0 + z1 u).
struct Places {
    float x0, x1, y0, y1, z0, z1;
};

/// The reference: grey levels, row by row.
struct Reference {
    const float* grey;
    int width;
    int height;
};

/// Counts of several properties, a byte or two each, that are added up together.
using Packed = unsigned;

/// Input and output of costs(). All arrays have one value a pixel of the row.
struct CostRow {
    const float* above;  ///< the row and its neighbours in the newer image
    const float* now;
    const float* below;
    const float* before;         ///< grey level of the floor in the reference; NaN: outside
    const float* before_nearer;  ///< the same of something a quarter nearer; null: not asked for
    const float* offset;         ///< local difference of brightness
    Places places;
    float v;
    float w0, w1;      ///< inverse distance of the floor: w0 + w1 u
    float bx, by, bz;  ///< displacement of the reference's camera, in its pixels
    float gain;
    float noise;        ///< standard deviation of differences of grey levels
    float* cost;        ///< of the floor
    float* steepness2;  ///< squared gradient of the finest detail
    Packed* counts;     ///< 1 for each property of the pixel, see below
    Packed* evidence;
    float* preference;  ///< cost of something nearer less that of the floor
};

/// A pixel that votes, and the contacts it votes for.
struct Vote {
    float u, v;
    float grey;
    float steepness2;
    float cost;        ///< of the floor
    float x, y, z;     ///< homogeneous place in the reference at infinity
    float bx, by, bz;  ///< its change with the inverse forward distance
    float noise2;
    float weight;
};

struct Functions {
    /// Grey levels of the reference at the places of the pixels begin to end - 1; NaN outside.
    void (*warp)(const Reference& reference, const Places& places, int begin, int end, float* out);
    void (*costs)(const CostRow& row, int begin, int end);
    /// After costs(): fills `preference`.
    void (*preferences)(const CostRow& row, int begin, int end);
    /// Where there is no floor: counts the pixels that the camera saw and the edges.
    void (*edges)(const CostRow& row, int begin, int end);
    /// Adds the differences of brightness, at most `limit` each, and their number to two sums a pixel.
    void (*differences)(const CostRow& row, float limit, int begin, int end, float* sums, float* numbers);
    /// Adds the votes of one pixel for contacts at the `count` inverse forward distances.
    void (*vote)(const Reference& reference, const Vote& vote, const float* inverse, int count, float* sums);
};

/// Those of the fastest instruction set that this processor has.
const Functions& functions();

/// Those of plain C++, which every processor has.
const Functions& portable_functions();

// Properties of a pixel, in CostRow::counts; at most 255 pixels may be added up.
constexpr Packed seen_one = 1U;       ///< the camera looked there
constexpr Packed edge_one = 1U << 8;  ///< on an edge of any direction
constexpr Packed compared_one =
    1U << 16;                            ///< its place in the reference is known, by the motion of the floor
constexpr Packed misfit_one = 1U << 24;  ///< compared: not as bright as the floor was there
// In CostRow::evidence. Informative: a quarter more inverse depth would show in the brightness of the pixel.
constexpr Packed floor_one = 1U;            ///< informative, and as bright as the floor was there
constexpr Packed not_floor_one = 1U << 16;  ///< informative misfit

constexpr float misfit_cost = 3.0F;         ///< more: does not move as the floor
constexpr float floor_cost = 1.0F;          ///< less: does
constexpr float edge_per_noise = 2.9F;      ///< gradient of an edge, smoothed
constexpr float plain_edge2 = 1.5F;         ///< where not smoothed: squared, times that
constexpr float parallax_per_noise = 2.4F;  ///< least change of brightness of an informative pixel
constexpr float gradient_per_noise = 1.2F;  ///< its least gradient
constexpr float displacement2_min = 0.25F;  ///< its least displacement along the gradient, squared pixels
constexpr float displacement2_per_tolerance2 = 4.0F;  ///< the same in tolerances of position
constexpr float position_error_px = 0.25F;            ///< of a place in the reference
constexpr float position_error_per_flow = 0.008F;     ///< added in quadrature, a pixel of flow
constexpr float cost_max = 4.0F;
constexpr float fit_cost = 1.0F;       ///< of an upright surface: a pixel with less votes for it
constexpr float least_telling = 0.3F;  ///< least weight of a pixel that fits contacts everywhere
constexpr float against = 2.5F;        ///< vote of a pixel with more: the votes of noise cancel

}  // namespace flownav::obstacles::rows
