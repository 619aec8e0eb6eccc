#include "view_window.h"

#include <array>

#include "sliders.h"

namespace flownav::view {

namespace {

constexpr int idle_ms = 10;
constexpr int repaint_ms = 16;
constexpr int margin_px = 6;
constexpr int button_px = 28;
constexpr int slider_px = 22;

/// Action of a key; empty for other keys.
std::optional<Action> action_of(int key, int modifiers) {
    const bool ten = (modifiers & GLFW_MOD_SHIFT) != 0;
    switch (key) {
        case GLFW_KEY_SPACE:
            return Action::PlayOrPause;
        case GLFW_KEY_LEFT:
            return ten ? Action::BackTen : Action::Back;
        case GLFW_KEY_RIGHT:
            return ten ? Action::ForwardTen : Action::Forward;
        case GLFW_KEY_HOME:
            return Action::Home;
        case GLFW_KEY_END:
            return Action::End;
        case GLFW_KEY_DOWN:
            return Action::Slower;
        case GLFW_KEY_UP:
            return Action::Faster;
        case GLFW_KEY_P:
            return Action::Predictions;
        case GLFW_KEY_C:
            return Action::Contacts;
        case GLFW_KEY_LEFT_BRACKET:
            return Action::MarkBegin;
        case GLFW_KEY_RIGHT_BRACKET:
            return Action::MarkEnd;
        case GLFW_KEY_S:
            return Action::SavePicture;
        case GLFW_KEY_M:
            return Action::SaveClip;
        case GLFW_KEY_Q:
        case GLFW_KEY_ESCAPE:
            return Action::Quit;
        default:
            return std::nullopt;
    }
}

unsigned int height_of(const ViewSession& session) {
    return static_cast<unsigned int>(session.size().height + ViewWindow::controls_px);
}

}  // namespace

ViewWindow::ViewWindow(ViewSession& session)
    : CDisplayWindowGUI(session.model().name() + " - flownav-view",
                        static_cast<unsigned int>(session.size().width), height_of(session)),
      session_(session) {
    picture_ = new PictureWidget(this);  // owned by its parent, like all widgets
    picture_->on_mouse = [this](const cv::Point& at, bool pressed) { session_.mouse(at, pressed); };
    picture_->on_leave = [this] { session_.mouse_left(); };
    picture_->on_wheel = [this](const cv::Point& at, double clicks) { session_.wheel(at, clicks); };
    add_button("|<", "first field (home)", Action::Home);
    add_button("<", "one field back (left)", Action::Back);
    add_button("play", "play or pause (space)", Action::PlayOrPause);
    play_ = buttons_.back();
    add_button(">", "one field ahead (right)", Action::Forward);
    add_button(">|", "last field (end)", Action::End);
    add_button("slower", "half the speed (down)", Action::Slower);
    add_button("faster", "twice the speed (up)", Action::Faster);
    add_button("predicted", "predicted vectors (P)", Action::Predictions);
    add_button("contacts", "contact scan (C)", Action::Contacts);
    add_button("[", "a stretch for MP4 begins here", Action::MarkBegin);
    add_button("]", "a stretch for MP4 ends here", Action::MarkEnd);
    add_button("save MP4", "the marked stretch, or all (M)", Action::SaveClip);
    add_button("save PNG", "this view (S)", Action::SavePicture);
    add_sliders();
    addKeyboardCallback([this](int key, int /*scancode*/, int action, int modifiers) {
        const auto wanted = action == GLFW_RELEASE ? std::nullopt : action_of(key, modifiers);
        if (wanted) act(*wanted);
        return wanted.has_value();
    });
    place();
    turn(0.0);
}

void ViewWindow::add_button(const std::string& caption, const std::string& tip, Action action) {
    auto* button = new nanogui::Button(this, caption);
    button->setTooltip(tip);
    button->setFontSize(16);
    button->setCallback([this, action] { act(action); });
    buttons_.push_back(button);
}

void ViewWindow::add_sliders() {
    for (std::size_t i = 0; i < slider_keys().size(); ++i) {
        Control control;
        control.label = new nanogui::Label(this, "");
        control.label->setFontSize(15);
        control.slider = new nanogui::Slider(this);
        control.slider->setCallback([this, i](float share) {
            session_.set_parameter(i, share);
            update_controls();
        });
        controls_.push_back(control);
    }
    update_controls();
}

/// Places the widgets by hand: the controls at the bottom, the picture above them.
void ViewWindow::place() {
    const int picture_height = std::max(1, height() - controls_px);
    session_.resize({width(), picture_height});
    picture_->setPosition({0, 0});
    picture_->setFixedSize({width(), picture_height});
    const int count = static_cast<int>(buttons_.size());
    const int button_width = (width() - margin_px) / count - margin_px;
    int x = margin_px;
    for (nanogui::Button* button : buttons_) {
        button->setPosition({x, picture_height + margin_px});
        button->setFixedSize({button_width, button_px});
        x += button_width + margin_px;
    }
    const int sliders = static_cast<int>(controls_.size());
    const int slider_width = (width() - margin_px) / sliders - margin_px;
    x = margin_px;
    const int top = picture_height + button_px + 2 * margin_px;
    for (const Control& control : controls_) {
        control.label->setPosition({x + 8, top});
        control.label->setFixedSize({slider_width - 8, 18});
        control.slider->setPosition({x, top + 20});
        control.slider->setFixedSize({slider_width, slider_px});
        x += slider_width + margin_px;
    }
    performLayout();
}

bool ViewWindow::resizeEvent(const nanogui::Vector2i& size) {
    const bool handled = CDisplayWindowGUI::resizeEvent(size);
    place();
    return handled;
}

void ViewWindow::act(Action action) {
    session_.act(action);
    if (session_.over()) setVisible(false);
}

void ViewWindow::update_controls() {
    for (std::size_t i = 0; i < controls_.size(); ++i) {
        const SliderKey& key = slider_keys()[i];
        const double share = slider_share(key, session_.model().config());
        controls_[i].slider->setValue(static_cast<float>(share));
        controls_[i].label->setCaption(key.label + "  " + slider_text(key, share));
    }
}

void ViewWindow::turn(double elapsed_s) {
    if (session_.turn(elapsed_s)) picture_->set_picture(session_.picture());
    const std::string caption = session_.model().playing() ? "pause" : "play";
    if (play_->caption() != caption) play_->setCaption(caption);
}

void ViewWindow::run() {
    last_turn_ = std::chrono::steady_clock::now();
    addLoopCallback([this] {
        const auto now = std::chrono::steady_clock::now();
        turn(std::chrono::duration<double>(now - last_turn_).count());
        last_turn_ = now;
    });
    setVisible(true);
    nanogui::mainloop(idle_ms, repaint_ms);
}

}  // namespace flownav::view
