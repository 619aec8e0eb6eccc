#include "view_window.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "flownav/report/label_style.h"
#include "view_samples.h"
#include "x_display.h"

/// Disables leak detection under sanitizers, because Mesa's drivers keep one-time allocations; other tests
/// detect leaks of the project. Also allows mismatched new and delete: nanogui's library, built for an older
/// C++, frees allocations of the operator new of C++17 in its headers.
extern "C" const char* __asan_default_options() {  // NOLINT
    return "detect_leaks=0:alloc_dealloc_mismatch=0";
}

namespace flownav::view {
namespace {

using namespace flownav::testing;
using nanogui::Vector2i;

int pixels_of(const cv::Mat& picture, const cv::Scalar& colour) {
    cv::Mat same;
    cv::inRange(picture, colour, colour, same);
    return cv::countNonZero(same);
}

/// The real window on a virtual display, driven by the events of the window system.
class Window : public ::testing::Test {
  protected:
    /// A folder of this process, because tests run in parallel.
    static std::filesystem::path display_folder() {
        return std::filesystem::path(::testing::TempDir()) / ("view_display_" + std::to_string(::getpid()));
    }
    static void SetUpTestSuite() {
        display = XDisplay::start(display_folder());
        if (!display) return;
        setenv("DISPLAY", display->name().c_str(), 1);
        nanogui::init();
    }
    static void TearDownTestSuite() {
        if (display) nanogui::shutdown();
        display.reset();
        std::filesystem::remove_all(display_folder());
    }

    void SetUp() override {
        if (!display) GTEST_SKIP() << "there is no Xvfb";
        model = std::make_unique<ViewModel>(view_options());
        finish(*model);
        command.size = {1200, 800};
        command.print_state = true;
        session = std::make_unique<ViewSession>(*model, command, out);
        window = new ViewWindow(*session);
        window->setVisible(true);
        show();
    }
    void TearDown() override { window = nullptr; }

    /// Runs two turns, so that the drawn picture has reached the display.
    void show(double elapsed_s = 0.0) {
        for (int i = 0; i < 2; ++i) {
            window->turn(i == 0 ? elapsed_s : 0.0);
            window->drawAll();
        }
    }

    void press(int key) {
        window->keyCallbackEvent(key, 0, GLFW_PRESS, 0);
        window->keyCallbackEvent(key, 0, GLFW_RELEASE, 0);
        show();
    }

    void click(int x, int y) {
        window->cursorPosCallbackEvent(x, y);
        window->mouseButtonCallbackEvent(GLFW_MOUSE_BUTTON_1, GLFW_PRESS, 0);
        window->mouseButtonCallbackEvent(GLFW_MOUSE_BUTTON_1, GLFW_RELEASE, 0);
        show();
    }

    nlohmann::json last_state() const {
        const std::string all = out.str();
        const auto begin = all.rfind('\n', all.size() - 2);
        return nlohmann::json::parse(all.substr(begin == std::string::npos ? 0 : begin + 1));
    }

    /// The part of the display that shows the window's picture.
    cv::Mat on_display() const {
        const cv::Mat screen = display->screenshot();
        return screen(cv::Rect({0, 0}, command.size)).clone();
    }

    /// Difference between the display and the session's picture, in grey levels. The display follows with a
    /// delay.
    double difference_on_display() {
        double difference = HUGE_VAL;
        for (int i = 0; i < 50 && difference >= 2.0; ++i) {
            difference = cv::norm(on_display(), session->picture(), cv::NORM_INF);
            if (difference >= 2.0) show();
        }
        return difference;
    }

    static std::unique_ptr<XDisplay> display;
    std::unique_ptr<ViewModel> model;
    ViewCommand command;
    std::ostringstream out;
    std::unique_ptr<ViewSession> session;
    nanogui::ref<ViewWindow> window;
};

std::unique_ptr<XDisplay> Window::display;

TEST_F(Window, ShowsThePictureOfTheSessionToThePixel) {
    press(GLFW_KEY_END);
    EXPECT_LT(difference_on_display(), 2.0);
    EXPECT_GT(pixels_of(on_display(), report::style_of(BlockLabel::Obstacle)->colour), 500);
}

TEST_F(Window, WhatItShowsIsTheStepRecord) {
    const auto expected = straight_run(corridor());
    for (int i = 0; i < 7; ++i) press(GLFW_KEY_RIGHT);
    EXPECT_EQ(last_state()["field"], 7);
    press(GLFW_KEY_LEFT);
    const pipeline::Step& step = expected[6];
    EXPECT_EQ(last_state()["field"], 6);
    EXPECT_EQ(last_state()["status"], to_string(step.status));
    EXPECT_EQ(last_state()["omega_radps"], step.omega_radps);
    EXPECT_EQ(last_state()["v_mps"], step.v_mps);
    EXPECT_EQ(last_state()["confident"], step.counts.confident);
}

TEST_F(Window, SpacePlaysAndPauses) {
    press(GLFW_KEY_SPACE);
    show(1.0);
    EXPECT_TRUE(last_state()["playing"]);
    EXPECT_NEAR(model->timeline().time_s(last_state()["field"]), 1.0, 0.09);
    press(GLFW_KEY_SPACE);
    show(1.0);
    EXPECT_FALSE(model->playing());
}

TEST_F(Window, TheMouseOverABlockShowsItsNumbers) {
    press(GLFW_KEY_END);
    const auto& blocks = model->frame().step.blocks;
    std::size_t wanted = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const Eigen::Vector2d now = blocks[i].vector.at_px + blocks[i].vector.flow_px;
        if (blocks[i].label == BlockLabel::Obstacle && now.x() > 20 && now.y() > 20) wanted = i;
    }
    const FlowVector& vector = blocks[wanted].vector;
    const cv::Point at = picture_px_of(*model, session->size(), vector.at_px + vector.flow_px);
    window->cursorPosCallbackEvent(at.x, at.y);
    show();
    ASSERT_TRUE(last_state().contains("hovered"));
    const auto hovered = last_state()["hovered"];
    const pipeline::BlockRecord& record = blocks[hovered["block"].get<std::size_t>()];
    EXPECT_EQ(hovered["flow_px"][0], record.vector.flow_px.x());
    EXPECT_EQ(hovered["confidence"], record.vector.confidence);
    EXPECT_TRUE(hovered.contains("sad"));
    EXPECT_LT(difference_on_display(), 2.0);
}

TEST_F(Window, AClickInTheChartGoesThere) {
    const cv::Rect strip = layout_of(session->size()).strip;
    click(strip.x + strip.width - 20, strip.y + 50);
    EXPECT_GT(last_state()["field"], 55);
}

TEST_F(Window, AButtonDoesWhatItsKeyDoes) {
    const int top = command.size.height + 20;
    click(command.size.width / 13 * 4 + 50, top);  // the fifth of thirteen buttons: last field
    EXPECT_EQ(last_state()["field"], 59);
    click(50, top);  // the first button: first field
    EXPECT_EQ(last_state()["field"], 0);
}

TEST_F(Window, ASliderRecomputesAtOnce) {
    press(GLFW_KEY_END);
    const int y = command.size.height + ViewWindow::controls_px - 20;
    click(60, y);  // the first slider: blocks
    EXPECT_TRUE(last_state()["preview"]);
    const int blocks = last_state()["parameters"]["blocks"];
    EXPECT_NE(blocks, 350);
    EXPECT_EQ(model->frame().step.blocks.size(), static_cast<std::size_t>(blocks));
    while (model->work(1000)) {
    }
    show();
    EXPECT_FALSE(last_state()["preview"]);
    config::Config config;
    config.pipeline.flow.blocks = blocks;
    EXPECT_EQ(last_state()["omega_radps"], straight_run(corridor(), config).back().omega_radps);
}

TEST_F(Window, ResizesItsPicture) {
    window->setSize(Vector2i(1000, 700));
    window->resizeCallbackEvent(1000, 700);
    show();
    EXPECT_EQ(session->picture().cols, 1000);
}

TEST_F(Window, QCloses) {
    press(GLFW_KEY_Q);
    EXPECT_TRUE(session->over());
    EXPECT_FALSE(window->visible());
}

}  // namespace
}  // namespace flownav::view
