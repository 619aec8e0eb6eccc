#include "view_app.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "app_runs.h"
#include "view_samples.h"

namespace flownav::view {
namespace {

using namespace flownav::testing;

Outcome run(const std::vector<std::string>& arguments) {
    const OpenWindow no_window = [](auto&, auto&, auto& out, auto&) {
        out << "window\n";
        return 0;
    };
    const auto app = [&](const std::vector<std::string>& all, std::ostream& out, std::ostream& error) {
        return run_view_app(all, no_window, out, error);
    };
    return run_app(app, "flownav-view", arguments);
}

TEST(ViewApp, SavesAPictureOfAMomentWithoutADisplay) {
    const std::string file = (test_folder() / "a.png").string();
    const Outcome outcome = run(
        {corridor().string(), "--screenshot", file, "--at", "2.5", "--size", "1000x700", "--print-state"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(cv::imread(file).size(), cv::Size(1000, 700));
    const auto state = nlohmann::json::parse(outcome.out);
    const auto expected = straight_run(corridor());
    const pipeline::Step& step = expected.at(state["field"].get<std::size_t>());
    EXPECT_NEAR(step.timestamp_s - expected.front().timestamp_s, 2.5, 0.08);
    EXPECT_EQ(state["omega_radps"], step.omega_radps);
    EXPECT_EQ(state["obstacle_blocks"], step.counts.obstacle);
}

TEST(ViewApp, TwoPicturesOfTheSameMomentAreTheSame) {
    const auto folder = test_folder();
    for (const char* name : {"a.png", "b.png"}) {
        run({corridor().string(), "--screenshot", (folder / name).string(), "--at", "3", "--point",
             "100,60"});
    }
    EXPECT_EQ(bytes_of_file(folder / "a.png"), bytes_of_file(folder / "b.png"));
}

TEST(ViewApp, OpensAWindowOtherwise) {
    EXPECT_EQ(run({corridor().string()}).out, "window\n");
}

TEST(ViewApp, BadUsageIsStatusOne) {
    const std::string file = corridor().string();
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {},
             {"--no-such-option"},
             {(test_folder() / "none.rawlog").string()},
             {test_folder().string()},
             {file, "--size", "3x3"},
             {file, "--size", "large"},
             {file, "--point", "7"},
             {file, "--set", "flow.blocks"},
             {file, "--set", "flow.blocks=-1"},
             {file, "--set", "flow.block=100"},
             {file, "--config", "/nowhere.ini"},
             {file, "--set", "camera.camera_label=OTHER", "--screenshot", "x.png"}}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 1) << outcome.out;
        EXPECT_NE(outcome.error, "");
    }
}

TEST(ViewApp, ADamagedInputIsShownAndStatusTwo) {
    const std::string picture = (test_folder() / "x.png").string();
    const auto file = test_folder() / "damaged.rawlog";
    write_bytes(file, bytes_of_file(corridor()).substr(0, 500'000));
    const Outcome outcome = run({file.string(), "--screenshot", picture, "--at", "1"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.error.find("object number"), std::string::npos) << outcome.error;
    EXPECT_FALSE(cv::imread(picture).empty());
    write_bytes(file, "this is no rawlog at all");
    EXPECT_EQ(run({file.string(), "--screenshot", picture}).status, 2);
}

TEST(ViewApp, APictureThatCannotBeWrittenIsStatusThree) {
    EXPECT_EQ(run({corridor().string(), "--screenshot", "/nowhere/x.png"}).status, 3);
}

}  // namespace
}  // namespace flownav::view
