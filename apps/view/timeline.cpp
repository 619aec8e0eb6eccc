#include "timeline.h"

#include <algorithm>

namespace flownav::view {

std::size_t Timeline::index_at(double time_s) const {
    constexpr double rounding_s = 1e-6;
    const double at_s = rows.front().timestamp_s + time_s + rounding_s;
    const auto after =
        std::upper_bound(rows.begin(), rows.end(), at_s,
                         [](double t, const evaluation::FieldRow& row) { return t < row.timestamp_s; });
    return after == rows.begin() ? 0 : static_cast<std::size_t>(after - rows.begin()) - 1;
}

std::string Timeline::end_text() const {
    if (!complete) return "";
    if (!stop_reason.empty()) return stop_reason + ". What came before is shown.";
    return end.kind == io::ReadEnd::Kind::Clean ? "" : end.message;
}

}  // namespace flownav::view
