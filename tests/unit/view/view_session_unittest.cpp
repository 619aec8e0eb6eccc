#include "view_session.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sliders.h"
#include "state_json.h"
#include "strip_panel.h"
#include "view_samples.h"

namespace flownav::view {
namespace {

using namespace flownav::testing;

/// Runs in its own folder, where files are saved.
class Session : public ::testing::Test {
  protected:
    Session() : home(std::filesystem::current_path()), model(view_options()) {
        std::filesystem::current_path(test_folder());
        finish(model);
        command.print_state = true;
    }
    ~Session() override { std::filesystem::current_path(home); }

    std::filesystem::path home;
    ViewModel model;
    ViewCommand command;
    std::ostringstream out;
};

TEST_F(Session, KeysMoveThroughTheDrive) {
    ViewSession session(model, command, out);
    EXPECT_TRUE(session.turn(0.0)) << "the first picture";
    EXPECT_FALSE(session.turn(0.0)) << "nothing has changed";
    session.act(Action::ForwardTen);
    session.act(Action::Forward);
    session.act(Action::Back);
    EXPECT_EQ(model.frame().index, 10U);
    EXPECT_TRUE(session.turn(0.0));
    session.act(Action::End);
    EXPECT_EQ(model.frame().index, 59U);
    session.act(Action::Home);
    EXPECT_EQ(model.frame().index, 0U);
    session.act(Action::PlayOrPause);
    session.act(Action::Faster);
    session.turn(1.0);
    EXPECT_NEAR(model.timeline().time_s(model.frame().index), 2.0, 0.09) << "twice as fast";
    EXPECT_FALSE(session.over());
    session.act(Action::Quit);
    EXPECT_TRUE(session.over());
}

TEST_F(Session, BeginsWhereItWasAskedTo) {
    command.at_s = 2.0;
    ViewSession session(model, command, out);
    session.turn(0.0);
    EXPECT_NEAR(model.timeline().time_s(model.frame().index), 2.0, 0.09);
    session.act(Action::Home);
    session.turn(0.0);
    EXPECT_EQ(model.frame().index, 0U) << "only once";
}

TEST_F(Session, AClickInTheChartGoesThere) {
    ViewSession session(model, command, out);
    const cv::Rect strip = layout_of(session.size()).strip;
    const int column = strip_column(model.timeline(), model.timeline().time_s(33), strip.width);
    session.mouse({strip.x + column, strip.y + 40}, false);
    EXPECT_EQ(model.frame().index, 0U) << "not before it is pressed";
    session.mouse({strip.x + column, strip.y + 40}, true);
    EXPECT_NEAR(static_cast<double>(model.frame().index), 33.0, 1.0);
}

TEST_F(Session, PointingAtABlockPrintsItsNumbers) {
    ViewSession session(model, command, out);
    model.show(40);
    const pipeline::BlockRecord& block = model.frame().step.blocks[5];
    session.mouse(picture_px_of(model, session.size(), block.vector.at_px + block.vector.flow_px), false);
    EXPECT_TRUE(session.turn(0.0));
    const auto state = nlohmann::json::parse(out.str());
    EXPECT_EQ(state["field"], 40);
    const auto& record = model.frame().step.blocks[state["hovered"]["block"].get<std::size_t>()];
    EXPECT_EQ(state["hovered"]["confidence"], record.vector.confidence);
    EXPECT_EQ(state["hovered"]["fate"], to_string(record.label));
    session.mouse_left();
    EXPECT_FALSE(model.hovered_block());
}

TEST_F(Session, SlidersSetTheirParameters) {
    ViewSession session(model, command, out);
    model.show(40);
    for (std::size_t i = 0; i < slider_keys().size(); ++i) {
        const SliderKey& key = slider_keys()[i];
        for (const double share : {0.0, 1.0, 0.5}) {
            session.set_parameter(i, share);
            const double expected = key.low + share * (key.high - key.low);
            EXPECT_NEAR(key.value(model.config()), expected, key.step) << key.key;
            EXPECT_NEAR(slider_share(key, model.config()), share, key.step / (key.high - key.low)) << key.key;
        }
        session.set_parameter(i, slider_share(key, config::Config{}));
        EXPECT_NEAR(key.value(model.config()), key.value(config::Config{}), 1e-9)
            << key.key << " back to its default";
    }
}

TEST_F(Session, TheWheelZoomsTheMapAlone) {
    ViewSession session(model, command, out);
    const ViewLayout layout = layout_of(session.size());
    const double before_m = session.look().ahead_m;
    session.wheel({layout.field.x + 5, layout.field.y + 5}, 1.0);
    EXPECT_EQ(session.look().ahead_m, before_m);
    session.wheel({layout.map.x + 5, layout.map.y + 5}, 1.0);
    EXPECT_LT(session.look().ahead_m, before_m);
    for (int i = 0; i < 100; ++i) session.wheel({layout.map.x + 5, layout.map.y + 5}, -1.0);
    EXPECT_EQ(session.look().ahead_m, 100.0);
    EXPECT_FALSE(session.picture().empty());
}

TEST_F(Session, TheContactScanIsSwitchedOffAndOn) {
    ViewSession session(model, command, out);
    EXPECT_TRUE(session.look().contacts);
    session.act(Action::Contacts);
    EXPECT_FALSE(session.look().contacts);
    EXPECT_TRUE(session.turn(0.0)) << "the picture changes";
    session.act(Action::Contacts);
    EXPECT_TRUE(session.look().contacts);
}

TEST_F(Session, TheStateTellsTheGateOfTheContactScan) {
    ViewSession session(model, command, out);
    session.turn(0.0);
    const auto state = nlohmann::json::parse(out.str());
    EXPECT_EQ(state["contacts"]["gate"], to_string(model.frame().contacts.scan().gate));
}

TEST_F(Session, SavesPicturesUnderNewNames) {
    ViewSession session(model, command, out);
    session.act(Action::SavePicture);
    session.act(Action::SavePicture);
    EXPECT_TRUE(std::filesystem::exists("corridor-view-1.png"));
    EXPECT_TRUE(std::filesystem::exists("corridor-view-2.png"));
    EXPECT_EQ(session.look().note, "saved corridor-view-2.png");
}

TEST_F(Session, ResizingChangesThePicture) {
    ViewSession session(model, command, out);
    session.turn(0.0);
    session.resize({1000, 700});
    EXPECT_TRUE(session.turn(0.0));
    EXPECT_EQ(session.picture().size(), cv::Size(1000, 700));
    session.resize({10, 10});
    EXPECT_EQ(session.picture().size(), cv::Size(least_width_px, least_height_px));
}

}  // namespace
}  // namespace flownav::view
