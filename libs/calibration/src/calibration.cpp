#include "flownav/calibration/calibration.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <optional>

#include "calibration_ini.h"
#include "calibration_start.h"
#include "flownav/cli/number_text.h"
#include "flownav/cli/usage_error.h"
#include "flownav/core/plane_geometry.h"
#include "flownav/core/version.h"
#include "flownav/evaluation/pose_fit.h"
#include "flownav/io/input_path.h"
#include "flownav/io/output_file.h"
#include "flownav/math/units.h"
#include "flownav/report/residual_picture.h"

namespace flownav::calibration {
namespace {

constexpr int rounds_max = 4;
constexpr double settled_deg = 0.01;
constexpr double rescale_min = 0.1;  // relative error of the height that gives cycles of the wrong length
constexpr double agreeing_caution = 0.65;  // below, the result carries a caution
constexpr double agreeing_min = 0.35;      // below, the result is rejected
constexpr double angle_sigma_max_deg = 0.3;
constexpr double scale_sigma_max = 0.05;
constexpr int pairs_min = 10;
constexpr double longer_cycles = 1.5;  // longer travel reduces the influence of pixel errors
constexpr motion::AngleMask all_angles = {true, true, true};

/// Thrown when the drive does not determine the pitch; what() holds the reason.
struct NotDetermined : std::runtime_error {
    using std::runtime_error::runtime_error;
};

void refuse_bad_input(const std::filesystem::path& input) {
    const std::string problem = io::problem_of_input(input);
    if (!problem.empty()) throw cli::UsageError(problem);
}

void refuse_overwriting(const CalibrationOptions& o) {
    std::error_code error;
    for (const auto& file : {o.output, o.picture}) {
        if (file.empty() || !std::filesystem::equivalent(o.input, file, error)) continue;
        throw cli::UsageError(file.string() + " is the input: choose another name for the output");
    }
}

std::string degrees_text(double angle_rad) {
    return cli::fixed_text(angle_rad / degree_rad, 3);
}

class Run {
  public:
    explicit Run(const CalibrationOptions& options)
        : options_(options), config_(options.config), progress_(std::cout, options.progress) {
        config_.pipeline.rate.travel_m *= longer_cycles;
    }

    CalibrationResult result() {
        refuse_bad_input(options_.input);
        refuse_overwriting(options_);
        const CalibrationStart start = find_start(options_.input, config_, options_.odometry);
        config_ = start.config;
        given_ = start.given;
        refine();
        collect_values();
        write();
        return result_;
    }

  private:
    void refine() {
        for (int round = 0; round < rounds_max; ++round) {
            drive_ = evaluation::collect_pairs(options_.input, config_, 0, progress_);
            if (drive_.fields == 0)
                throw cli::UsageError("no field could be used in " + options_.input.string());
            fit_ = evaluation::fit_angles(drive_.pairs, motion::MountAngles::Zero(), all_angles);
            if (options_.odometry) scale_ = evaluation::fit_scale(travel_pieces(), drive_.odometry);
            require_determined();
            keep_undetermined_angles();
            const bool rescale = scale_ && std::abs(scale_->ratio - 1.0) > rescale_min;
            if (fit_.correction_rad.norm() < settled_deg * degree_rad && !rescale) return;
            set_angles(config_, final_mount());
            if (rescale) config_.camera.height_m = plausible_height(assumed().height_m * scale_->ratio);
        }
    }

    std::vector<evaluation::TravelPiece> travel_pieces() const {
        std::vector<evaluation::TravelPiece> pieces;
        for (const evaluation::CalibrationPair& pair : drive_.pairs) {
            if (!pair.motion.forward_measured) continue;
            pieces.push_back({pair.begin_s, pair.end_s, pair.motion.forward_m});
        }
        return pieces;
    }

    static double plausible_height(double height_m) { return std::clamp(height_m, 0.01, 20.0); }

    CameraMount assumed() const { return drive_.pairs.front().reference.mount; }
    CameraMount final_mount() const { return motion::corrected(assumed(), fit_.correction_rad); }

    bool determined(int angle) const { return fit_.sigma_rad[angle] < angle_sigma_max_deg * degree_rad; }

    /// Keeps angles that the drive does not determine, and fits the others again.
    void keep_undetermined_angles() {
        const motion::AngleMask known = {true, determined(1), determined(2)};
        if (known == all_angles) return;
        const CameraMount mount = assumed();
        motion::MountAngles start = motion::MountAngles::Zero();
        if (!known[1]) start[1] = given_.roll_rad - mount.roll_rad;
        if (!known[2]) start[2] = given_.yaw_rad - mount.yaw_rad;
        const motion::MountAngles sigma = fit_.sigma_rad;
        fit_ = evaluation::fit_angles(drive_.pairs, start, known);
        if (!known[1]) fit_.sigma_rad[1] = sigma[1];
        if (!known[2]) fit_.sigma_rad[2] = sigma[2];
    }

    void require_determined() const {
        const std::string found = "the drive does not determine the camera's pitch: ";
        const std::string advice = "; drive a few metres over a textured floor";
        if (fit_.pairs < pairs_min) {
            throw NotDetermined(found + "only " + std::to_string(fit_.pairs) + " of " +
                                std::to_string(drive_.cycles) + " pairs of fields show enough floor" +
                                advice);
        }
        if (!determined(0)) {
            throw NotDetermined(found + "its uncertainty is " + degrees_text(fit_.sigma_rad[0]) +
                                " deg after " + cli::fixed_text(drive_.path_m, 2) + " m of travel" + advice);
        }
        if (!fit_.settled || !within_ranges(final_mount()) || fit_.agreeing < agreeing_min) {
            throw NotDetermined(found + "no pose explains it: " + cli::fixed_text(100 * fit_.agreeing, 0) +
                                " % of the near vectors agree with a floor at the best one (pitch " +
                                degrees_text(final_mount().pitch_rad) +
                                " deg). Is the floor in view, and are the focal lengths right?");
        }
    }

    void collect_values() {
        const CameraMount found = final_mount();
        const auto angle = [this](const char* key, double before, double after, int i) {
            result_.values.push_back({key, "deg", before / degree_rad, after / degree_rad,
                                      fit_.sigma_rad[i] / degree_rad, determined(i)});
        };
        angle("pitch_deg", given_.pitch_rad, found.pitch_rad, 0);
        angle("roll_deg", given_.roll_rad, found.roll_rad, 1);
        angle("yaw_deg", given_.yaw_rad, found.yaw_rad, 2);
        add_height(found);
        add_notes();
    }

    void add_height(const CameraMount& found) {
        CalibratedValue value{"height_m", "m", given_.height_m, found.height_m, 0.0, false};
        if (scale_) {
            const double relative =
                std::hypot(scale_->sigma / scale_->ratio, travel_per_pitch(found) * fit_.sigma_rad[0]);
            value.after = found.height_m * scale_->ratio;
            value.sigma = value.after * relative;
            value.determined = relative < scale_sigma_max && value.after == plausible_height(value.after);
        }
        result_.values.push_back(value);
    }

    /// Relative change of the measured travel with the assumed pitch, per radian.
    double travel_per_pitch(const CameraMount& mount) const {
        const CameraModel& camera = drive_.pairs.front().reference;
        const PlaneGeometry plane(mount);
        const double y = (camera.height_px * 5.0 / 6.0 - camera.cy_px) / camera.fy_px;
        return 2.0 * (plane.a - plane.b * y) / std::max(0.05, plane.below_horizon({0.0, y}));
    }

    void add_notes() {
        result_.notes.push_back(
            std::to_string(fit_.pairs) + " pairs of fields from " + options_.input.filename().string() +
            ", " + cli::fixed_text(drive_.duration_s, 1) + " s, " + cli::fixed_text(drive_.path_m, 1) + " m");
        if (fit_.agreeing < agreeing_caution) {
            result_.notes.push_back("Only " + cli::fixed_text(100 * fit_.agreeing, 0) +
                                    " % of the near vectors agree with a plane: take the values with care. A "
                                    "level floor with nothing on it calibrates better.");
        }
        if (!options_.odometry) {
            result_.notes.emplace_back(
                "The height stays as it was: flow alone does not tell it. Give --odometry to take it from "
                "the "
                "recording's odometry.");
        } else if (!scale_) {
            result_.notes.emplace_back(
                "The height stays as it was: the recording has no odometry over pieces of forward driving.");
        }
    }

    void write() {
        std::vector<std::string> header = {"Camera pose estimated by flownav-calibrate " +
                                           std::string(version())};
        header.insert(header.end(), result_.notes.begin(), result_.notes.end());
        for (const CalibratedValue& value : result_.values) header.push_back(describe(value));
        io::write_file(options_.output, calibration_ini(options_.config, result_.values, header));
        compare();
        if (drive_.end.kind != io::ReadEnd::Kind::Clean || !drive_.stop_reason.empty()) {
            result_.status = CalibrationStatus::Input;
            result_.message = "the input could not be read to its end: " +
                              (drive_.stop_reason.empty() ? drive_.end.message : drive_.stop_reason) +
                              ". What came before was used.";
        }
    }

    void compare() {
        const CameraMount used = assumed();
        const motion::MountAngles before(given_.pitch_rad - used.pitch_rad, given_.roll_rad - used.roll_rad,
                                         given_.yaw_rad - used.yaw_rad);
        const report::ResidualComparison residuals =
            report::compare_residuals(drive_.pairs, before, fit_.correction_rad);
        result_.notes.push_back("Residual of the floor: " + cli::fixed_text(residuals.before.median_px, 3) +
                                " px before, " + cli::fixed_text(residuals.after.median_px, 3) + " px after");
        if (options_.picture.empty()) return;
        std::vector<std::uint8_t> png;
        cv::imencode(
            ".png",
            report::residual_picture(drive_.first_field, residuals,
                                     "before: pitch " + degrees_text(given_.pitch_rad) + " deg",
                                     "after: pitch " + degrees_text(final_mount().pitch_rad) + " deg"),
            png);
        io::write_file(options_.picture, {reinterpret_cast<const char*>(png.data()), png.size()});
    }

    const CalibrationOptions& options_;
    config::Config config_;
    cli::Progress progress_;
    CameraMount given_;  ///< mount before the calibration
    evaluation::CalibrationDrive drive_;
    evaluation::AnglesFit fit_;
    std::optional<evaluation::ScaleFit> scale_;
    CalibrationResult result_;
};

CalibrationResult failed(CalibrationStatus status, const std::exception& error) {
    return {status, error.what(), {}, {}};
}

}  // namespace

CalibrationResult calibrate(const CalibrationOptions& options) {
    try {
        return Run(options).result();
    } catch (const NotDetermined& error) {
        return failed(CalibrationStatus::NotDetermined, error);
    } catch (const io::OutputError& error) {
        return failed(CalibrationStatus::Output, error);
    } catch (const io::InputError& error) {
        return failed(CalibrationStatus::Input, error);
    } catch (const std::runtime_error& error) {  // UsageError, ConfigError
        return failed(CalibrationStatus::Usage, error);
    }
}

}  // namespace flownav::calibration
