#include "flownav/regress/figure_rules.h"

#include <cmath>

namespace flownav::regress {

namespace {

/// Tolerances of the figures whose name matches: a share, and an absolute difference that is always allowed.
struct Row {
    const char* prefix;
    const char* suffix;
    double share;
    double difference;
    Better better;
};

/// The first matching row applies. One machine reproduces all figures exactly; the tolerances cover other
/// arithmetic libraries and insignificant changes.
constexpr Row rows[] = {
    {"read.", "", 0, 0, Better::Unknown},
    {"rejected.", "", 0, 0, Better::Unknown},
    {"warnings.", "", 0, 0, Better::Unknown},
    {"status.ok", "", 0, 1, Better::Higher},
    {"status.", "", 0, 1, Better::Lower},
    {"written.obstacle_points", "", 0.02, 3, Better::Unknown},
    {"written.map_", "", 0.02, 3, Better::Unknown},
    {"written.", "", 0, 1, Better::Unknown},
    {"drive.", "_s", 0, 1e-6, Better::Unknown},
    {"drive.", "path_m", 0.002, 0.001, Better::Unknown},
    {"drive.", "_m", 0, 0.005, Better::Unknown},
    {"drive.", "_deg", 0, 0.05, Better::Unknown},
    {"contacts.rows", "", 0.02, 50, Better::Unknown},
    {"contacts.scanned_percent", "", 0, 2, Better::Higher},
    {"contacts.decided_2m_percent", "", 0, 2, Better::Higher},
    {"contacts.by_gate.open", "", 0.02, 1, Better::Higher},
    {"contacts.by_gate.", "", 0.02, 1, Better::Lower},
    {"contacts.by_cause.", "", 0.05, 3, Better::Unknown},
    {"contacts.floor_fit", "", 0, 0.02, Better::Higher},
    {"contacts.vignetting", "", 0, 0.02, Better::Unknown},
    {"contacts.", "", 0.05, 0.3, Better::Unknown},
    {"errors.", ".fields_compared", 0, 1, Better::Higher},
    {"errors.", "_rms_degps", 0.1, 0.002, Better::Lower},
    {"errors.", ".v_bias_percent", 0, 0.05, Better::NearerZero},
    {"errors.", ".v_sd_percent", 0.1, 0.02, Better::Lower},
    {"errors.", ".t_measured_percent", 0, 1, Better::Higher},
    {"errors.", ".end_position_percent", 0, 0.05, Better::Lower},
    {"errors.", ".heading_end_deg", 0, 0.03, Better::NearerZero},
    {"errors.", ".path_m", 0.002, 0.001, Better::Unknown},
    {"camera_check.pairs", "", 0.05, 3, Better::Unknown},
    {"camera_check.", "_deg", 0, 0.05, Better::Unknown},
    {"camera_check.", "", 0, 0.02, Better::Unknown},
    {"", "", 0.02, 1e-9, Better::Unknown},
};

bool fits(const Row& row, const std::string& figure) {
    const std::string prefix = row.prefix;
    const std::string suffix = row.suffix;
    return figure.size() >= prefix.size() + suffix.size() && figure.compare(0, prefix.size(), prefix) == 0 &&
           figure.compare(figure.size() - suffix.size(), suffix.size(), suffix) == 0;
}

const Row& row_of(const std::string& figure) {
    for (const Row& row : rows)
        if (fits(row, figure)) return row;
    return rows[0];  // not reached: the last row matches every figure
}

int sign(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

}  // namespace

double Tolerance::width(double expected) const {
    return relative ? value * std::abs(expected) : value;
}

FigureRule figure_rule(const std::string& figure, double expected) {
    const Row& row = row_of(figure);
    const bool relative = row.share * std::abs(expected) > row.difference;
    return {{relative ? row.share : row.difference, relative}, row.better};
}

int verdict_on(Better better, double before, double after) {
    switch (better) {
        case Better::Lower:
            return sign(before - after);
        case Better::Higher:
            return sign(after - before);
        case Better::NearerZero:
            return sign(std::abs(before) - std::abs(after));
        case Better::Unknown:
            break;
    }
    return 0;
}

}  // namespace flownav::regress
