#include "live_recorder.h"

#include <gtest/gtest.h>

#include "flownav/io/rawlog_reader.h"
#include "view_samples.h"

namespace flownav::view {
namespace {

using namespace flownav::testing;

std::filesystem::path ini_with(const std::string& lines) {
    const auto file = test_folder() / "live.ini";
    write_bytes(file, "[FLOW]\ndriver = CFlowObstacleSensor\n" + lines);
    return file;
}

TEST(LiveRecorder, WhatASourceGivesIsFollowedByTheViewer) {
    const auto expected = straight_run(corridor());
    std::filesystem::path spooled;
    {
        const LiveRecorder spool(
            ini_with("grabber_type = rawlog\nrawlog_file = " + corridor().string() + "\n"));
        spooled = spool.file();
        ViewOptions options = view_options(spool.file());
        options.config = spool.config();
        options.follow = true;
        ViewModel model(options);
        while (spool.problem().empty()) finish(model);
        finish(model);
        EXPECT_EQ(spool.problem(), "the source is at its end");
        ASSERT_EQ(model.timeline().rows.size(), expected.size());
        EXPECT_FALSE(model.timeline().odometry.empty());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const evaluation::FieldRow& row = model.timeline().rows[i];
            EXPECT_EQ(row.timestamp_s, expected[i].timestamp_s);
            EXPECT_EQ(row.status, expected[i].status);
            EXPECT_NEAR(row.omega_radps, expected[i].omega_radps, 1e-6);
            EXPECT_NEAR(row.v_mps, expected[i].v_mps, 1e-6);
        }
    }
    EXPECT_FALSE(std::filesystem::exists(spooled)) << "the temporary file is gone";
}

TEST(LiveRecorder, ASourceThatCannotBeUsedIsAnError) {
    EXPECT_THROW(LiveRecorder("/nowhere.ini"), config::ConfigError);
    EXPECT_THROW(LiveRecorder(ini_with("grabber_type = rawlog\nrawlog_file = /nowhere.rawlog\n")),
                 io::InputError);
    const auto poses = test_folder() / "poses.rawlog";
    write_bytes(poses, serialized({odometry_at(1, 0), odometry_at(2, 0)}));
    const auto ini = poses.parent_path() / "live.ini";
    write_bytes(ini, "[FLOW]\ndriver = CFlowObstacleSensor\ngrabber_type = rawlog\nrawlog_file = " +
                         poses.string() + "\n");
    EXPECT_THROW(LiveRecorder(ini.string()), io::InputError);
}

}  // namespace
}  // namespace flownav::view
