#include "view_model.h"

#include <gtest/gtest.h>

#include <random>

#include "flownav/cli/exit_status.h"
#include "flownav/cli/number_text.h"
#include "flownav/replay/replay.h"
#include "view_samples.h"

namespace flownav::view {
namespace {

using namespace flownav::testing;

TEST(ViewModel, ShowsTheFirstFieldBeforeTheBackgroundHasReadAnything) {
    const ViewModel model(view_options());
    EXPECT_EQ(model.frame().index, 0U);
    EXPECT_FALSE(model.frame().field.image.empty());
    EXPECT_TRUE(model.timeline().rows.empty());
    EXPECT_FALSE(model.timeline().complete);
}

TEST(ViewModel, EveryNumberIsThatOfReplayWhereverOneLooks) {
    const auto expected = straight_run(corridor());
    for (const std::size_t memory : {std::size_t{1} << 30, std::size_t{1'000'000}}) {
        ViewOptions options = view_options();
        options.checkpoint_bytes = memory;
        ViewModel model(options);
        finish(model);
        std::minstd_rand random(7);
        for (int i = 0; i < 60; ++i) {
            const std::size_t index = random() % expected.size();
            model.show(index);
            EXPECT_EQ(model.frame().index, index);
            EXPECT_FALSE(model.frame().preview);
            EXPECT_EQ(fingerprint(model.frame().step), fingerprint(expected[index])) << index;
        }
    }
}

TEST(ViewModel, TheTimelineIsThatOfEgomotionCsv) {
    ViewModel model(view_options());
    finish(model);
    replay::ReplayOptions replaying;
    replaying.input = corridor();
    replaying.output = test_folder() / "out";
    ASSERT_EQ(replay::replay(replaying).status, cli::ExitStatus::Fine);
    std::istringstream csv(bytes_of_file(replaying.output / "egomotion.csv"));
    std::string line;
    std::getline(csv, line);
    for (const evaluation::FieldRow& row : model.timeline().rows) {
        ASSERT_TRUE(std::getline(csv, line));
        std::string start = cli::time_text(row.timestamp_s) + ',' + to_string(row.status) + ',';
        if (row.status == FieldStatus::Ok) start += cli::fixed_text(row.omega_radps, 6);
        EXPECT_EQ(line.substr(0, start.size()), start);
        const std::string carried =
            ',' + std::to_string(row.obstacles) + ',' + cli::fixed_text(row.carried.since_s, 6) + ',' +
            cli::fixed_text(row.carried.sigma_m, 4) + ',' + cli::fixed_text(row.carried.sigma_rad, 5) + ',';
        EXPECT_NE(line.find(carried), std::string::npos) << line;
        if (row.status != FieldStatus::Waiting) {
            EXPECT_NE(line.find(',' + cli::fixed_text(row.v_mps, 6) + ','), std::string::npos) << line;
        }
    }
    EXPECT_FALSE(std::getline(csv, line));
}

TEST(ViewModel, NewParametersShowAPreviewAtOnceAndTheExactResultWhenItIsThere) {
    ViewModel model(view_options());
    finish(model);
    model.show(50);
    const std::string before = fingerprint(model.frame().step);
    const Pose2 pose = model.frame().step.T_start_robot;
    model.set("obstacles.tau_px", "3");
    EXPECT_EQ(model.frame().index, 50U);
    EXPECT_TRUE(model.frame().preview);
    EXPECT_NE(fingerprint(model.frame().step), before);
    EXPECT_EQ(model.timeline().current, 0U);
    EXPECT_EQ(model.timeline().rows.size(), 60U) << "the earlier chart stays until there is a newer";
    EXPECT_NEAR(model.frame().step.T_start_robot.x_m, pose.x_m, 0.02);
    EXPECT_NEAR(model.frame().step.T_start_robot.y_m, pose.y_m, 0.02);

    config::Config config;
    config::set_config_value(config, "obstacles.tau_px", "3");
    const auto expected = straight_run(corridor(), config);
    model.work(40);
    model.poll();
    EXPECT_TRUE(model.frame().preview);
    EXPECT_EQ(model.timeline().current, 40U);
    model.show(30);
    EXPECT_FALSE(model.frame().preview);
    EXPECT_EQ(fingerprint(model.frame().step), fingerprint(expected[30]));
    model.show(50);
    EXPECT_TRUE(model.frame().preview);
    model.show(51);
    EXPECT_TRUE(model.frame().preview);
    finish(model);
    EXPECT_FALSE(model.frame().preview);
    EXPECT_EQ(fingerprint(model.frame().step), fingerprint(expected[51]));
    EXPECT_EQ(model.timeline().current, 60U);
}

TEST(ViewModel, ManyChangesInARowKeepTheDrive) {
    ViewModel model(view_options());
    finish(model);
    model.show(45);
    for (const char* value : {"100", "200", "300", "400"}) {
        model.set("flow.blocks", value);
        model.work(3);
        EXPECT_EQ(model.frame().step.blocks.size(), std::stoul(value));
        EXPECT_EQ(model.frame().index, 45U);
    }
    EXPECT_THROW(model.set("flow.blocks", "-3"), config::ConfigError);
    EXPECT_EQ(model.config().pipeline.flow.blocks, 400) << "a bad value changes nothing";
}

TEST(ViewModel, ChangesBeforeAnythingHasBeenReadAreExact) {
    ViewModel model(view_options());
    model.set("flow.blocks", "100");
    EXPECT_EQ(model.frame().index, 0U);
    finish(model);
    config::Config config;
    config::set_config_value(config, "flow.blocks", "100");
    model.show(20);
    EXPECT_EQ(fingerprint(model.frame().step), fingerprint(straight_run(corridor(), config)[20]));
}

TEST(ViewModel, PointingAtABlockGivesItsRecord) {
    ViewModel model(view_options());
    finish(model);
    model.show(40);
    for (std::size_t i = 0; i < model.frame().step.blocks.size(); ++i) {
        const pipeline::BlockRecord& block = model.frame().step.blocks[i];
        if (block.label != BlockLabel::Obstacle) continue;
        model.hover(Eigen::Vector2d(block.vector.at_px + block.vector.flow_px));
        ASSERT_TRUE(model.hovered_block());
        const pipeline::BlockRecord& found = model.frame().step.blocks[*model.hovered_block()];
        EXPECT_EQ(found.vector.at_px + found.vector.flow_px, block.vector.at_px + block.vector.flow_px);
        EXPECT_TRUE(model.hovered_window());
    }
    model.hover(Eigen::Vector2d(-50, -50));
    EXPECT_FALSE(model.hovered_block());
    model.hover(std::nullopt);
    EXPECT_FALSE(model.hovered_window());
}

TEST(ViewModel, PlaysInTheTimeOfTheDriveAndStopsAtItsEnd) {
    ViewModel model(view_options());
    finish(model);
    model.set_playing(true);
    model.play_for(1.0);
    EXPECT_NEAR(model.timeline().time_s(model.frame().index), 1.0, 0.09);
    model.set_speed(0.5);
    model.play_for(1.0);
    EXPECT_NEAR(model.timeline().time_s(model.frame().index), 1.5, 0.09);
    model.play_for(1000.0);
    EXPECT_EQ(model.frame().index, 59U);
    EXPECT_FALSE(model.playing());
    model.set_playing(true);
    EXPECT_EQ(model.frame().index, 0U) << "from the start";
    model.step_by(3);
    EXPECT_FALSE(model.playing()) << "stepping pauses";
    EXPECT_EQ(model.frame().index, 3U);
    model.step_by(-10);
    EXPECT_EQ(model.frame().index, 0U);
}

TEST(ViewModel, ACutFileShowsWhatIsReadableAndSaysWhereItEnds) {
    const auto file = cut_corridor(0.5);
    ViewModel model(view_options(file));
    finish(model);
    const auto expected = straight_run(file);
    EXPECT_EQ(model.timeline().rows.size(), expected.size());
    EXPECT_NE(model.timeline().end_text().find("object number"), std::string::npos);
    model.show(1000);
    EXPECT_EQ(fingerprint(model.frame().step), fingerprint(expected.back()));
}

TEST(ViewModel, AGrowingFileIsFollowed) {
    const std::string all = bytes_of_file(corridor());
    const auto file = test_folder() / "growing.rawlog";
    write_bytes(file, all.substr(0, all.size() / 3));
    ViewOptions options = view_options(file);
    options.follow = true;
    ViewModel model(options);
    finish(model);
    const std::size_t first = model.timeline().rows.size();
    EXPECT_LT(first, 30U);
    std::ofstream(file, std::ios::binary | std::ios::app) << all.substr(all.size() / 3);
    finish(model);
    const auto expected = straight_run(corridor());
    ASSERT_EQ(model.timeline().rows.size(), expected.size());
    for (const std::size_t index : {first - 1, first, first + 1, expected.size() - 1}) {
        model.show(index);
        EXPECT_EQ(fingerprint(model.frame().step), fingerprint(expected[index]));
    }
}

TEST(ViewModel, ARawlogWithoutUsableImagesIsRefusedInTheWordsOfReplay) {
    const auto folder = test_folder();
    const auto file = folder / "poses.rawlog";
    write_bytes(file, serialized({odometry_at(1, 0), truth_at(2, 0)}));
    replay::ReplayOptions replaying;
    replaying.input = file;
    replaying.output = folder / "out";
    try {
        const ViewModel model(view_options(file));
        FAIL() << "nothing can be shown";
    } catch (const config::ConfigError& error) {
        EXPECT_EQ(std::string(error.what()), replay::replay(replaying).message);
    }
    EXPECT_THROW(ViewModel(view_options(folder / "none.rawlog")), io::InputError);
}

TEST(ViewModel, WithoutOdometryAndTruthThereIsNothingOfThem) {
    const auto file = test_folder() / "images.rawlog";
    write_bytes(file, serialized({image_at(1, 1), image_at(1.04, 2), image_at(1.08, 3)}));
    ViewModel model(view_options(file));
    finish(model);
    EXPECT_TRUE(model.timeline().odometry.empty());
    EXPECT_TRUE(model.timeline().ground_truth.empty());
    EXPECT_EQ(model.timeline().rows.size(), 3U);
    EXPECT_TRUE(model.timeline().end_text().empty());
}

TEST(ViewModel, TheBackgroundThreadFindsTheSame) {
    ViewOptions options = view_options();
    options.way = BackgroundReader::Way::Thread;
    ViewModel model(options);
    while (!model.timeline().complete) model.poll();
    model.set("flow.blocks", "200");
    model.set("flow.blocks", "350");
    while (!model.timeline().complete) model.poll();
    const auto expected = straight_run(corridor());
    ASSERT_EQ(model.timeline().rows.size(), expected.size());
    model.show(33);
    EXPECT_EQ(fingerprint(model.frame().step), fingerprint(expected[33]));
}

}  // namespace
}  // namespace flownav::view
