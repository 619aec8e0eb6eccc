#pragma once

#include <string>

namespace flownav::regress {

/// Allowed deviation of a figure from its expected value, relative or absolute.
struct Tolerance {
    double value = 0.0;
    bool relative = false;  ///< share of the expected value

    /// Returns the tolerance as an absolute difference.
    double width(double expected) const;
};

/// Direction of improvement.
enum class Better { Unknown, Lower, Higher, NearerZero };

/// Tolerance and direction of improvement of one figure.
struct FigureRule {
    Tolerance tolerance;
    Better better = Better::Unknown;
};

/// Returns the rule for a figure such as "errors.odometry.v_sd_percent" by its name and expected value: small
/// counts and errors near zero get an absolute tolerance, others a relative one.
FigureRule figure_rule(const std::string& figure, double expected);

/// Rates a change from `before` to `after`: +1 better, -1 worse, 0 undecided.
int verdict_on(Better better, double before, double after);

}  // namespace flownav::regress
