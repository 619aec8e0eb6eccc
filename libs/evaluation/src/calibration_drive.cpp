#include "flownav/evaluation/calibration_drive.h"

#include <cmath>
#include <optional>
#include <variant>

#include "flownav/config/make_state.h"
#include "flownav/pipeline/pipeline.h"

namespace flownav::evaluation {
namespace {

constexpr std::size_t most_pairs = 1200;

/// Switches the online estimate of the pitch off: a calibration needs a constant pitch.
config::Config without_learning(config::Config config) {
    config.pipeline.pitch_online = false;
    return config;
}

/// Collects the pairs of a drive.
class Collector {
  public:
    explicit Collector(const config::Config& config) : state_(config::make_state(without_learning(config))) {}

    void take(const Field& field) {
        const pipeline::Step& step = pipeline::step(state_, field);
        if (drive.fields++ == 0) {
            drive.first_field = field;
            first_s_ = field.timestamp_s;
        }
        drive.duration_s = field.timestamp_s - first_s_;
        const bool compared = step.image_of_cycle > 0 && step.status != FieldStatus::BadField;
        // Uses the images of the second half of each cycle, so that vectors have different fractions of a
        // pixel.
        if (compared && 2 * step.image_of_cycle >= step.cycle_images && offered_++ % stride_ == 0)
            keep(field, step);
        if (step.end_of_cycle) {
            drive.path_m += std::abs(step.motion.forward_m);
            ++drive.cycles;
        }
        if (step.end_of_cycle || step.image_of_cycle == 0) {
            reference_ = field.camera;
            reference_s_ = field.timestamp_s;
        }
    }

    CalibrationDrive drive;

  private:
    void keep(const Field& field, const pipeline::Step& step) {
        CalibrationPair pair{reference_s_, field.timestamp_s, reference_, field.camera, step.motion, {}};
        for (const pipeline::BlockRecord& block : step.blocks)
            if (block.fresh) pair.vectors.push_back(block.vector);
        drive.pairs.push_back(std::move(pair));
        if (drive.pairs.size() < most_pairs) return;
        std::vector<CalibrationPair> half;
        for (std::size_t i = 0; i < drive.pairs.size(); i += 2) half.push_back(std::move(drive.pairs[i]));
        drive.pairs = std::move(half);
        stride_ *= 2;
    }

    pipeline::State state_;
    CameraModel reference_;
    double reference_s_ = 0.0;
    double first_s_ = 0.0;
    std::uint64_t offered_ = 0;
    std::uint64_t stride_ = 1;
};

}  // namespace

CalibrationDrive collect_pairs(const std::filesystem::path& input, const config::Config& config,
                               std::uint64_t cycles_max, cli::Progress& progress) {
    io::RawlogReader reader(input);
    io::FieldSource source(reader, config.camera, config.input);
    Collector collector(config);
    CalibrationDrive& drive = collector.drive;
    try {
        while (const auto event = source.next()) {
            if (const auto* field = std::get_if<Field>(&*event)) collector.take(*field);
            const auto* pose = std::get_if<io::PoseSample>(&*event);
            if (pose != nullptr && pose->source == io::PoseSample::Source::Odometry)
                drive.odometry.add(pose->timestamp_s, pose->pose);
            progress.update(reader.progress(), drive.fields);
            if (cycles_max > 0 && drive.cycles >= cycles_max) break;
        }
    } catch (const config::ConfigError& error) {
        if (drive.fields == 0) throw;
        drive.stop_reason = error.what();
    }
    progress.finish(drive.fields);
    drive.odometry.finish();
    drive.end = reader.end();
    return std::move(drive);
}

}  // namespace flownav::evaluation
