#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "flownav/evaluation/metrics.h"
#include "flownav/io/field_source.h"
#include "flownav/pipeline/pipeline.h"

namespace flownav {
namespace {

/// The folder of the optional recordings.
std::filesystem::path data_folder() {
    const char* given = std::getenv("FLOWNAV_DATA");
    return given != nullptr ? given : FLOWNAV_DATA;
}

/// The errors of the default configuration against the recorded truth.
evaluation::Errors errors_of(const std::filesystem::path& rawlog) {
    const config::Config config;
    io::RawlogReader reader(rawlog);
    io::FieldSource source(reader, config.camera);
    pipeline::State state(config.pipeline);
    std::vector<evaluation::FieldRow> rows;
    evaluation::PoseTrack truth;
    while (const auto event = source.next()) {
        if (const auto* field = std::get_if<Field>(&*event))
            rows.push_back(evaluation::row_of(pipeline::step(state, *field)));
        const auto* sample = std::get_if<io::PoseSample>(&*event);
        if (sample != nullptr && sample->source == io::PoseSample::Source::GroundTruth)
            truth.add(sample->timestamp_s, sample->pose);
    }
    truth.finish();
    EXPECT_EQ(reader.end().kind, io::ReadEnd::Kind::Clean) << reader.end().message;
    return evaluation::compare(rows, truth);
}

TEST(RecordedScene, FieldSceneReachesItsNumbers) {
    const std::filesystem::path rawlog = data_folder() / "scenes/field.rawlog";
    if (!std::filesystem::exists(rawlog))
        GTEST_SKIP() << "no " << rawlog << "; set FLOWNAV_DATA to the folder with the recordings";
    const evaluation::Errors errors = errors_of(rawlog);
    ASSERT_GT(errors.fields_compared, 100U);
    EXPECT_LT(errors.omega_rms_degps.value(), 0.10);
    EXPECT_LT(errors.omega_cycle_rms_degps.value(), 0.03);
    EXPECT_LT(std::abs(errors.v_bias_percent.value()), 0.4);
    EXPECT_LT(errors.v_sd_percent.value(), 0.5);
    EXPECT_LT(errors.end_position_percent.value(), 1.0);
    EXPECT_LT(std::abs(errors.heading_end_deg.value()), 0.2);
}

}  // namespace
}  // namespace flownav
