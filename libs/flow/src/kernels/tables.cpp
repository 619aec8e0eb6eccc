#include "units.h"

namespace flownav::flow::kernels {
namespace {

constexpr int middle = side / 2;  ///< row and column of the offset (0, 0)
constexpr int distinct = 3;

constexpr int square(int index) {
    const int nu = index / side - middle;
    const int mu = index % side - middle;
    return mu * mu + nu * nu;
}

constexpr bool is_near(int a, int b) {
    return a - b < distinct && b - a < distinct;
}

/// Rank of an offset in the tie-break: by |(mu, nu)|^2, then in raster order.
constexpr int rank_of(int index) {
    int before = 0;
    for (int other = 0; other < offsets; ++other) {
        before += square(other) < square(index) || (square(other) == square(index) && other < index);
    }
    return before;
}

constexpr SummaryTables make_tables() {
    SummaryTables tables{};
    for (int index = 0; index < offsets; ++index) {
        const int rank = rank_of(index);
        tables.rank[index] = static_cast<uint16_t>(rank);
        tables.order[rank] = static_cast<uint8_t>(index);
    }
    for (int i = 0; i < side; ++i) {
        for (int d = 0; d < 2 * side; ++d) tables.near_rows[d][i] = is_near(d, side - 1) ? 0xFFFF : 0;
        for (int c = 0; c < side; ++c) tables.near_columns[c][i] = is_near(c, i) ? 0xFFFF : 0;
    }
    return tables;
}

}  // namespace

const SummaryTables summary_tables = make_tables();

}  // namespace flownav::flow::kernels
