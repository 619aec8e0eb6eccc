#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "block_panel.h"
#include "field_panel.h"
#include "flownav/report/cause_style.h"
#include "flownav/report/label_style.h"
#include "map_panel.h"
#include "strip_panel.h"
#include "view_picture.h"
#include "view_samples.h"

namespace flownav::view {
namespace {

using namespace flownav::testing;

int pixels_of(const cv::Mat& picture, const cv::Scalar& colour) {
    cv::Mat same;
    cv::inRange(picture, colour, colour, same);
    return cv::countNonZero(same);
}

cv::Mat around(const cv::Mat& picture, const cv::Point& at, int reach) {
    const cv::Rect area(at.x - reach, at.y - reach, 2 * reach + 1, 2 * reach + 1);
    return picture(area & cv::Rect({0, 0}, picture.size()));
}

class Panels : public ::testing::Test {
  protected:
    Panels() : model(view_options()) {
        finish(model);
        model.show(59);
        while (!model.frame().step.end_of_cycle) model.step_by(-1);
    }

    /// Index of a block with this label well inside the field.
    std::size_t block_of(BlockLabel label) const {
        const auto& blocks = model.frame().step.blocks;
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            const Eigen::Vector2d now = blocks[i].vector.at_px + blocks[i].vector.flow_px;
            const bool inside = now.x() > 20 && now.y() > 20 &&
                                now.x() < model.frame().field.image.width_px - 20 &&
                                now.y() < model.frame().field.image.height_px - 20;
            if (blocks[i].label == label && inside) return i;
        }
        ADD_FAILURE() << "no such block";
        return 0;
    }

    cv::Point shown_at(std::size_t block, const cv::Size& panel) const {
        const FlowVector& vector = model.frame().step.blocks[block].vector;
        return field_place(model.frame().field, panel).panel_px(vector.at_px + vector.flow_px);
    }

    ViewModel model;
    const cv::Size size{900, 700};
};

TEST_F(Panels, AnObstacleHasTheColourOfObstaclesWhereItIsNow) {
    const cv::Mat panel = field_panel({model.frame(), {}, std::nullopt, false}, size);
    EXPECT_EQ(panel.size(), size);
    for (const BlockLabel label : {BlockLabel::Obstacle, BlockLabel::Ground}) {
        const cv::Mat there = around(panel, shown_at(block_of(label), size), 9);
        EXPECT_GT(pixels_of(there, report::style_of(label)->colour), 5) << to_string(label);
    }
}

TEST_F(Panels, ThePixelUnderTheMouseIsThatOfTheField) {
    const FieldPlace place = field_place(model.frame().field, size);
    for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(10, 10), Eigen::Vector2d(100, 50)}) {
        const auto back = place.field_px(place.panel_px(pixel));
        ASSERT_TRUE(back);
        EXPECT_LT((*back - pixel).norm(), 1.0);
    }
    EXPECT_FALSE(place.field_px({-1, 5}));
    EXPECT_FALSE(place.field_px({size.width / 2, size.height - 1})) << "in the legend";
}

TEST_F(Panels, PredictionsAndThePointedBlockAreDrawnOnDemand) {
    const cv::Mat plain = field_panel({model.frame(), {}, std::nullopt, false}, size);
    EXPECT_GT(cv::norm(plain, field_panel({model.frame(), {}, std::nullopt, true}, size)), 100.0);
    const std::size_t block = block_of(BlockLabel::Obstacle);
    const cv::Mat pointed = field_panel({model.frame(), {}, block, false}, size);
    EXPECT_GT(pixels_of(around(pointed, shown_at(block, size), 30), {66, 228, 240}), 20);
}

TEST_F(Panels, TheMapShowsThePointsOfTheCycleWhereTheRobotSeesThem) {
    const cv::Mat panel = map_panel({model.frame(), model.timeline()}, size);
    ASSERT_FALSE(model.frame().step.obstacles.empty());
    int near = 0;
    for (const ObstaclePoint& point : model.frame().step.obstacles) {
        const cv::Point at = map_px(point.position_m.head<2>(), size, 8.0);
        near += pixels_of(around(panel, at, 2), report::style_of(BlockLabel::Obstacle)->colour) > 3;
    }
    EXPECT_GT(near, static_cast<int>(model.frame().step.obstacles.size()) / 2);
    EXPECT_LT(map_px({1.0, 0.0}, size, 8.0).y, map_px({0.0, 0.0}, size, 8.0).y) << "ahead is up";
    EXPECT_LT(map_px({0.0, 1.0}, size, 8.0).x, map_px({0.0, 0.0}, size, 8.0).x) << "left is left";
}

/// The frame with a contact 1.5 m ahead on the left by votes, and one on the right by a wall.
Frame with_contacts(const Frame& plain) {
    Frame frame = plain;
    ContactStrip left;
    left.kind = BeamKind::Obstacle;
    left.cause = BeamCause::Votes;
    left.contact_m = left.near_m = left.far_m = 1.5;
    ContactStrip right = left;
    right.cause = BeamCause::Wall;
    frame.step.new_contacts = true;
    frame.step.contacts.gate = ContactGate::Open;
    frame.step.contacts.T_robot_scan = {};
    frame.step.contacts.first = -1;
    frame.step.contacts.step = 0.2;
    frame.step.contacts.strips = {left, right};
    frame.contacts.take(frame.step);
    return frame;
}

TEST_F(Panels, ContactsAreDrawnInTheFieldOnTheSideWhereTheyAre) {
    const Frame frame = with_contacts(model.frame());
    const cv::Mat panel = field_panel({frame, {}, std::nullopt, false}, size);
    const FieldPlace place = field_place(frame.field, size);
    const cv::Mat picture = panel(place.area);
    const cv::Mat right_half = picture.colRange(picture.cols / 2 + 4, picture.cols);
    const cv::Scalar wall = report::colour_of(BeamCause::Wall);
    EXPECT_GT(pixels_of(right_half, wall), 20);
    const cv::Mat hidden = field_panel({frame, {}, std::nullopt, false, false}, size);
    const cv::Mat plain = field_panel({model.frame(), {}, std::nullopt, false, false}, size);
    EXPECT_EQ(cv::norm(hidden, plain), 0.0) << "switched off";
}

TEST_F(Panels, ContactsAreDrawnInTheMapWhereTheyStand) {
    const Frame frame = with_contacts(model.frame());
    const cv::Mat panel = map_panel({frame, model.timeline()}, size);
    const cv::Scalar wall = report::colour_of(BeamCause::Wall);
    EXPECT_GT(pixels_of(around(panel, map_px({1.5, -0.15}, size, 8.0), 2), wall), 3) << "right: y < 0";
    EXPECT_EQ(pixels_of(around(panel, map_px({1.5, 0.15}, size, 8.0), 2), wall), 0);
    MapPanelContent without{frame, model.timeline()};
    without.contacts = false;
    EXPECT_EQ(pixels_of(map_panel(without, size), wall), 0);
}

TEST_F(Panels, TheChartLeadsFromAColumnToItsTimeAndBack) {
    for (const double time_s : {0.0, 1.2, 4.7}) {
        const int column = strip_column(model.timeline(), time_s, 1400);
        EXPECT_NEAR(strip_time_s(model.timeline(), column, 1400), time_s, 0.005);
    }
    EXPECT_EQ(strip_time_s(model.timeline(), 0, 1400), 0.0);
    EXPECT_NEAR(strip_time_s(model.timeline(), 9999, 1400), model.timeline().time_s(59), 1e-9);
}

TEST_F(Panels, TheChartMarksTheFieldShownAndTheStatus) {
    const cv::Mat panel = strip_panel({model.timeline(), model.frame().index, std::nullopt}, {1400, 220});
    const int now = strip_column(model.timeline(), model.timeline().time_s(model.frame().index), 1400);
    EXPECT_GT(pixels_of(panel.col(now), cv::Scalar(30, 30, 30)), 150);
    EXPECT_GT(pixels_of(panel, report::colour_of(FieldStatus::Ok)), 5000);
}

TEST_F(Panels, ABlockTellsEveryNumberOfItsRecord) {
    const std::size_t block = block_of(BlockLabel::Obstacle);
    const auto lines = block_lines(model.frame(), block);
    EXPECT_EQ(lines.size(), 13U);
    EXPECT_NE(lines[0].find("obstacle"), std::string::npos);
    const cv::Mat empty = block_panel(model.frame(), std::nullopt, std::nullopt, {500, 300});
    model.hover(Eigen::Vector2d(model.frame().step.blocks[block].vector.at_px +
                                model.frame().step.blocks[block].vector.flow_px));
    const cv::Mat panel =
        block_panel(model.frame(), model.hovered_block(), model.hovered_window(), {500, 300});
    EXPECT_GT(cv::norm(panel, empty), 1000.0);
}

TEST_F(Panels, EverySizeIsDrawn) {
    for (const cv::Size small :
         {cv::Size(640, 480), cv::Size(1001, 777), cv::Size(3000, 700), cv::Size(1, 1)}) {
        const cv::Mat picture = view_picture(model, {}, small);
        EXPECT_EQ(picture.cols, std::max(small.width, least_width_px));
        EXPECT_EQ(picture.rows, std::max(small.height, least_height_px));
    }
    for (const cv::Size tiny : {cv::Size(20, 20), cv::Size(50, 300), cv::Size(300, 30)}) {
        field_panel({model.frame(), {}, std::nullopt, true}, tiny);
        map_panel({model.frame(), model.timeline()}, tiny);
        strip_panel({model.timeline(), 0, std::nullopt}, tiny);
        block_panel(model.frame(), 0, std::nullopt, tiny);
    }
}

TEST_F(Panels, WildNumbersDoNoHarm) {
    Frame frame = model.frame();
    frame.step.blocks[0].vector.at_px = {-500, 9000};
    frame.step.blocks[1].vector.flow_px = {1e6, -1e6};
    frame.step.blocks[1].predicted_px = {-1e6, 1e6};
    frame.step.T_start_robot = {1e5, -1e5, 3.0};
    EXPECT_FALSE(field_panel({frame, {}, 1, true}, size).empty());
    EXPECT_FALSE(map_panel({frame, model.timeline()}, size).empty());
    EXPECT_FALSE(block_panel(frame, 1, std::nullopt, size).empty());
    EXPECT_FALSE(field_panel({{}, {}, std::nullopt, true}, size).empty()) << "no field at all";
    EXPECT_FALSE(strip_panel({{}, 3, std::nullopt}, size).empty()) << "no drive at all";
}

}  // namespace
}  // namespace flownav::view
