#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/core/pose2.h"

namespace flownav {

/// Faults of the experiment.
enum class Fault {
    None,
    Frozen,        ///< repeats one image with new time stamps
    Black,         ///< every pixel 0
    Saturated,     ///< every pixel 255
    HalfCovered,   ///< the left or the right half of the image is dark, with a little noise
    Delayed,       ///< fields arrive a second late
    Dropped,       ///< 30 % of the fields are lost at random
    OdometryJump,  ///< the pose of the wheel odometry jumps once
    NavigatorHung,
    Mover,  ///< an object enters the lane
};

constexpr std::array<Fault, 9> all_faults = {Fault::Frozen,       Fault::Black,         Fault::Saturated,
                                             Fault::HalfCovered,  Fault::Delayed,       Fault::Dropped,
                                             Fault::OdometryJump, Fault::NavigatorHung, Fault::Mover};

inline const char* to_string(Fault fault) {
    constexpr std::array<const char*, 10> words = {"none",           "frozen",  "black",   "saturated",
                                                   "half_covered",   "delayed", "dropped", "odometry_jump",
                                                   "navigator_hung", "mover"};
    return words.at(static_cast<std::size_t>(fault));
}

/// Fault and its period; times are those of the fields, wheels and commands.
struct FaultPlan {
    Fault fault = Fault::None;
    double from_s = 0.0;
    double until_s = 0.0;
    std::uint64_t seed = 1;

    bool holds(double time_s) const { return time_s >= from_s && time_s < until_s; }
};

/// Deterministic number in 0 .. 1 from a seed and a count, equal on every machine.
inline double chance(std::uint64_t seed, std::uint64_t count) {
    std::uint64_t x = seed * 0x9E3779B97F4A7C15ULL + count * 0xBF58476D1CE4E5B9ULL + 0x94D049BB133111EBULL;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
    return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

/// Copies a field with new pixel values.
inline Field repainted(const Field& field,
                       const std::function<std::uint8_t(int u, int v, std::uint8_t grey)>& paint) {
    const ImageView& image = field.image;
    auto pixels = std::make_shared<std::vector<std::uint8_t>>();
    pixels->reserve(static_cast<std::size_t>(image.width_px) * image.height_px);
    for (int v = 0; v < image.height_px; ++v)
        for (int u = 0; u < image.width_px; ++u) pixels->push_back(paint(u, v, image.at(u, v)));
    Field changed = field;
    changed.image = {pixels->data(), image.width_px, image.height_px, image.width_px};
    changed.owner = pixels;
    return changed;
}

/// Applies the faults to a stream of fields.
class BrokenFields {
  public:
    explicit BrokenFields(const FaultPlan& plan) : plan_(plan) {}

    /// Returns the field as it arrives; empty when it is lost. `time_s` is a time of the plan.
    std::optional<Field> operator()(const Field& field, double time_s) {
        ++fields_;
        if (!plan_.holds(time_s)) return field;
        switch (plan_.fault) {
            case Fault::Frozen:
                return frozen(field);
            case Fault::Black:
                return repainted(field, [](int, int, std::uint8_t) -> std::uint8_t { return 0; });
            case Fault::Saturated:
                return repainted(field, [](int, int, std::uint8_t) -> std::uint8_t { return 255; });
            case Fault::HalfCovered:
                return half_covered(field);
            case Fault::Dropped:
                if (chance(plan_.seed, fields_) < 0.3) return {};
                return field;
            default:
                return field;
        }
    }

  private:
    Field frozen(const Field& field) {
        if (!frozen_) frozen_ = field;
        Field again = *frozen_;
        again.timestamp_s = field.timestamp_s;
        return again;
    }

    Field half_covered(const Field& field) const {
        const bool left = chance(plan_.seed, 0) < 0.5;
        const int middle = field.image.width_px / 2;
        return repainted(field, [&](int u, int v, std::uint8_t grey) -> std::uint8_t {
            if ((u < middle) != left) return grey;
            const auto pixel = static_cast<std::uint64_t>(v) * 65536 + static_cast<std::uint64_t>(u);
            return static_cast<std::uint8_t>(12.0 + 4.0 * chance(plan_.seed + fields_, pixel));
        });
    }

    FaultPlan plan_;
    std::uint64_t fields_ = 0;
    std::optional<Field> frozen_;
};

/// Adds the jump of the wheel odometry from plan.from_s on.
inline Pose2 broken_odometry(const FaultPlan& plan, double time_s, const Pose2& T_odom_robot) {
    if (plan.fault != Fault::OdometryJump || time_s < plan.from_s) return T_odom_robot;
    const double sign = chance(plan.seed, 1) < 0.5 ? -1.0 : 1.0;
    const Pose2 jump{sign * (0.3 + chance(plan.seed, 2)), 0.5 * chance(plan.seed, 3),
                     sign * chance(plan.seed, 4)};
    return compose(T_odom_robot, jump);
}

}  // namespace flownav
