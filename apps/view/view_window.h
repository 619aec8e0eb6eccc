#pragma once
#include <mrpt/gui/CDisplayWindowGUI.h>

#include <chrono>
#include <vector>

#include "picture_widget.h"
#include "view_session.h"

namespace flownav::view {

/// The window: shows the session's picture with buttons and sliders below it, and passes on the user's input.
/// Needs a display.
class ViewWindow : public mrpt::gui::CDisplayWindowGUI {
  public:
    explicit ViewWindow(ViewSession& session);

    /// Advances the session by `elapsed_s` and prepares the picture for drawAll().
    void turn(double elapsed_s);

    /// Shows the window until it is closed.
    void run();

    /// Height of the controls below the picture.
    static constexpr int controls_px = 92;

    bool resizeEvent(const nanogui::Vector2i& size) override;

  private:
    struct Control {
        nanogui::Label* label = nullptr;
        nanogui::Slider* slider = nullptr;
    };

    void add_button(const std::string& caption, const std::string& tip, Action action);
    void add_sliders();
    void place();
    void update_controls();
    void act(Action action);

    ViewSession& session_;
    PictureWidget* picture_ = nullptr;
    std::vector<nanogui::Button*> buttons_;
    nanogui::Button* play_ = nullptr;
    std::vector<Control> controls_;
    std::chrono::steady_clock::time_point last_turn_;
};

}  // namespace flownav::view
