#include "calibration_start.h"

#include <cmath>
#include <iostream>
#include <optional>

#include "flownav/math/units.h"

namespace flownav::calibration {
namespace {

constexpr std::uint64_t stretch_cycles = 100;
constexpr int stretch_rounds = 3;
constexpr double settled_deg = 0.1;
constexpr double agreeing_min = 0.5;  // share of the near vectors; below, other starts are tried
constexpr double sigma_max_deg = 1.0;
constexpr int scan_first_deg = 5, scan_last_deg = 65, scan_step_deg = 10;
constexpr double height_unknown_m = 1.0;

/// Hypothesis of the camera's pose, and the vectors of a stretch of the drive that agree with it.
struct Hypothesis {
    config::Config config;
    double agreeing_vectors = 0.0;
    double agreeing = 0.0;
};

evaluation::CalibrationDrive stretch(const std::filesystem::path& input, const config::Config& config,
                                     std::uint64_t cycles) {
    cli::Progress silent(std::cout, cli::Progress::Style::Silent);
    return evaluation::collect_pairs(input, config, cycles, silent);
}

/// Refines a hypothesis to the best fit of the first stretch of the drive.
Hypothesis settled(const std::filesystem::path& input, config::Config config) {
    Hypothesis h{std::move(config), 0.0, 0.0};
    for (int round = 0; round < stretch_rounds; ++round) {
        const evaluation::CalibrationDrive drive = stretch(input, h.config, stretch_cycles);
        if (drive.pairs.empty()) return h;
        const evaluation::AnglesFit fit =
            evaluation::fit_angles(drive.pairs, motion::MountAngles::Zero(), {true, true, true});
        const CameraMount mount = motion::corrected(drive.pairs.front().reference.mount, fit.correction_rad);
        // A pure rotation agrees with many vectors under any pose.
        const bool determined =
            fit.settled && within_ranges(mount) && fit.sigma_rad[0] < sigma_max_deg * degree_rad;
        h.agreeing = determined ? fit.agreeing : 0.0;
        h.agreeing_vectors = determined ? fit.agreeing_vectors : 0.0;
        if (!determined) return h;
        set_angles(h.config, mount);
        if (fit.correction_rad.norm() < settled_deg * degree_rad) break;
    }
    return h;
}

}  // namespace

CalibrationStart find_start(const std::filesystem::path& input, config::Config config, bool odometry) {
    std::optional<Hypothesis> best;
    std::optional<CameraMount> given;
    try {
        given = stretch(input, config, 1).first_field.camera.mount;
        best = settled(input, config);
        if (best->agreeing >= agreeing_min) return {best->config, *given};
    } catch (const config::ConfigError&) {
        if (config.camera.pitch_deg) throw;
        if (odometry && !config.camera.height_m) config.camera.height_m = height_unknown_m;
    }
    for (int pitch_deg = scan_first_deg; pitch_deg <= scan_last_deg; pitch_deg += scan_step_deg) {
        config.camera.pitch_deg = pitch_deg;
        if (!given) given = stretch(input, config, 1).first_field.camera.mount;
        const Hypothesis h = settled(input, config);
        if (!best || h.agreeing_vectors > best->agreeing_vectors) best = h;
    }
    return {best->config, *given};
}

bool within_ranges(const CameraMount& m) {
    return m.pitch_rad > -5 * degree_rad && m.pitch_rad < 80 * degree_rad &&
           std::abs(m.roll_rad) < 10 * degree_rad && std::abs(m.yaw_rad) < 10 * degree_rad;
}

void set_angles(config::Config& config, const CameraMount& mount) {
    config.camera.pitch_deg = mount.pitch_rad / degree_rad;
    config.camera.roll_deg = mount.roll_rad / degree_rad;
    config.camera.yaw_deg = mount.yaw_rad / degree_rad;
}

}  // namespace flownav::calibration
