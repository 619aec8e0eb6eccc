#include "clip.h"

#include <gtest/gtest.h>

#include <opencv2/videoio.hpp>

#include "flownav/io/output_file.h"
#include "view_samples.h"
#include "view_session.h"

namespace flownav::view {
namespace {

using namespace flownav::testing;

TEST(Clip, HoldsThePicturesOfTheMarkedStretch) {
    ViewModel model(view_options());
    finish(model);
    model.show(12);
    model.mark_end();
    model.show(5);
    model.mark_begin();
    const auto file = test_folder() / "clip.mp4";
    Clip clip(model, file, {801, 601});
    while (clip.add_next(model, {})) {
    }
    clip.close();
    EXPECT_EQ(clip.pictures(), 8U);
    EXPECT_EQ(model.frame().index, 12U);
    cv::VideoCapture video(file.string(), cv::CAP_FFMPEG);
    EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_COUNT), 8.0);
    EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_WIDTH), 800.0);
    EXPECT_NEAR(video.get(cv::CAP_PROP_FPS), 12.5, 0.1) << "as fast as the drive";
}

TEST(Clip, AFileThatCannotBeWrittenIsAnError) {
    ViewModel model(view_options());
    finish(model);
    EXPECT_THROW(Clip(model, "/nowhere/clip.mp4", {800, 600}), io::OutputError);
    EXPECT_THROW(save_picture("/nowhere/view.png", cv::Mat(3, 3, CV_8UC3)), io::OutputError);
}

TEST(Clip, ASessionWritesItFieldByField) {
    const auto home = std::filesystem::current_path();
    std::filesystem::current_path(test_folder());
    ViewModel model(view_options());
    finish(model);
    model.show(3);
    model.mark_end();
    ViewCommand command;
    command.size = {640, 480};
    std::ostringstream out;
    ViewSession session(model, command, out);
    session.act(Action::SaveClip);
    int turns = 0;
    for (; session.saves_clip() && turns < 100; ++turns) session.turn(0.0);
    EXPECT_EQ(turns, 5);
    EXPECT_EQ(session.look().note, "saved corridor-view-1.mp4, 4 pictures");
    std::filesystem::current_path(home);
}

}  // namespace
}  // namespace flownav::view
