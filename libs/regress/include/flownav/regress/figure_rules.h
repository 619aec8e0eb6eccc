#pragma once

#include <string>

namespace flownav::regress {

/// How far a figure may be from what is expected: a share of it, or a difference.
struct Tolerance {
    double value = 0.0;
    bool relative = false;  ///< share of the expected value

    /// As a difference, for this expected value.
    double width(double expected) const;
};

/// Which way is better.
enum class Better { Unknown, Lower, Higher, NearerZero };

/// What a change of one figure means.
struct FigureRule {
    Tolerance tolerance;
    Better better = Better::Unknown;
};

/// By the name of a figure, such as "errors.odometry.v_sd_percent", and its expected value: small counts and
/// errors near zero get a difference, others a share.
FigureRule figure_rule(const std::string& figure, double expected);

/// +1 where a change from `before` to `after` is to the better, -1 to the worse, 0 where one cannot say.
int verdict_on(Better better, double before, double after);

}  // namespace flownav::regress
