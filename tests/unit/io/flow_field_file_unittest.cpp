#include "flownav/io/flow_field_file.h"

#include <gtest/gtest.h>

#include "flownav/io/flow_field_observation.h"
#include "flownav/io/rawlog_reader.h"
#include "rawlog_files.h"
#include "step_samples.h"

namespace flownav::io {
namespace {

using testing::content;
using testing::pal_field;
using testing::step_at;
using testing::test_folder;

void write_sample(const std::filesystem::path& file) {
    FlowFieldFile fields(file);
    for (int i = 0; i < 9; ++i) fields.write(pal_field(i), step_at(i));
    fields.close();
}

TEST(FlowFieldFile, HoldsTheRecordOfEveryField) {
    const auto file = test_folder() / "fields.rawlog";
    write_sample(file);
    RawlogReader reader(file);
    int fields = 0;
    while (const auto observation = reader.next()) {
        const auto field = std::dynamic_pointer_cast<CObservationFlowField>(observation);
        ASSERT_TRUE(field);
        const pipeline::Step step = step_at(fields);
        EXPECT_EQ(field->step.timestamp_s, step.timestamp_s);
        EXPECT_EQ(field->step.status, step.status);
        EXPECT_EQ(field->step.omega_radps, step.omega_radps);
        EXPECT_EQ(field->step.blocks.size(), step.blocks.size());
        EXPECT_EQ(field->step.obstacles.size(), step.obstacles.size());
        EXPECT_EQ(field->camera.width_px, 768);
        EXPECT_EQ(field->camera.mount.pitch_rad, pal_field(fields).camera.mount.pitch_rad);
        ++fields;
    }
    EXPECT_EQ(reader.end().kind, ReadEnd::Kind::Clean) << reader.end().message;
    EXPECT_EQ(fields, 9);
}

TEST(FlowFieldFile, TheSameStepsGiveTheSameBytes) {
    const auto folder = test_folder();
    write_sample(folder / "a");
    write_sample(folder / "b");
    EXPECT_EQ(content(folder / "a"), content(folder / "b"));
}

TEST(FlowFieldFile, AFullDiskIsAnErrorThatNamesTheFile) {
    try {
        FlowFieldFile fields("/dev/full");
        fields.write(pal_field(0), step_at(0));
        fields.close();
        FAIL() << "nobody noticed";
    } catch (const OutputError& error) {
        EXPECT_NE(std::string(error.what()).find("/dev/full"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace flownav::io
