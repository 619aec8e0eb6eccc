#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "flownav/replay/curves.h"
#include "flownav/replay/number_text.h"

namespace flownav {

namespace {

constexpr double left_px = 84;  ///< as in the charts, so that times stand below each other
constexpr int columns = 660;

/// Of the fields that share a column of pixels the worst is shown, lest a single bad one be lost.
int severity(FieldStatus status) {
    switch (status) {
        case FieldStatus::Ok:
            return 0;
        case FieldStatus::Waiting:
            return 1;
        case FieldStatus::NoTexture:
            return 2;
        case FieldStatus::Lost:
            return 3;
        case FieldStatus::BadField:
            return 4;
    }
    return 0;
}

using Band = std::array<std::optional<FieldStatus>, columns>;

Band band_of(const std::vector<FieldRow>& rows) {
    Band band;
    const double start_s = rows.front().timestamp_s;
    const double duration_s = std::max(1e-9, rows.back().timestamp_s - start_s);
    const auto column = [&](double time_s) {
        return std::clamp(static_cast<int>((time_s - start_s) / duration_s * columns), 0, columns - 1);
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool last = i + 1 == rows.size();
        const int to = last ? columns - 1 : column(rows[i + 1].timestamp_s);
        for (int c = column(rows[i].timestamp_s); c <= to; ++c) {
            auto& shown = band.at(static_cast<std::size_t>(c));
            if (!shown || severity(rows[i].status) > severity(*shown)) shown = rows[i].status;
        }
    }
    return band;
}

std::string stripe(std::size_t from, std::size_t to, FieldStatus status) {
    return "<rect x='" + fixed_text(left_px + static_cast<double>(from), 0) + "' y='28' width='" +
           std::to_string(to - from) + "' height='22' fill='" + colour_of(status) + "'><title>" +
           to_string(status) + "</title></rect>\n";
}

}  // namespace

const char* colour_of(FieldStatus status) {
    switch (status) {
        case FieldStatus::Ok:
            return "#009e73";
        case FieldStatus::Waiting:
            return "#bbbbbb";
        case FieldStatus::NoTexture:
            return "#f0e442";
        case FieldStatus::Lost:
            return "#d55e00";
        case FieldStatus::BadField:
            return "#000000";
    }
    return "none";
}

std::string status_band(const std::vector<FieldRow>& rows) {
    std::string svg =
        "<svg viewBox='0 0 760 56' role='img' aria-label='Status over time'>\n<text class='title' "
        "x='84' y='17'>Status over time</text>\n";
    if (rows.empty()) return svg + "</svg>\n";
    const Band band = band_of(rows);
    for (std::size_t from = 0; from < band.size();) {
        std::size_t to = from + 1;
        while (to < band.size() && band.at(to) == band.at(from)) ++to;
        if (band.at(from)) svg += stripe(from, to, *band.at(from));
        from = to;
    }
    return svg + "</svg>\n";
}

}  // namespace flownav
