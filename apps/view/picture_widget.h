#pragma once
#include <nanogui/nanogui.h>

#include <functional>
#include <opencv2/core/mat.hpp>

namespace flownav::view {

/// Shows a picture pixel by pixel and reports mouse events in its pixels.
class PictureWidget : public nanogui::Widget {
  public:
    explicit PictureWidget(nanogui::Widget* parent) : Widget(parent) {}
    ~PictureWidget() override = default;

    /// Sets the picture, 8-bit BGR.
    void set_picture(const cv::Mat& picture);

    std::function<void(const cv::Point& at, bool pressed)> on_mouse;  ///< called on a press or move
    std::function<void()> on_leave;
    std::function<void(const cv::Point& at, double clicks)> on_wheel;  ///< > 0: away from the user

    void draw(NVGcontext* context) override;
    bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
    bool mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                          int modifiers) override;
    bool mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                        int modifiers) override;
    bool mouseEnterEvent(const nanogui::Vector2i& p, bool enter) override;
    bool scrollEvent(const nanogui::Vector2i& p, const nanogui::Vector2f& rel) override;

  private:
    cv::Point in_picture(const nanogui::Vector2i& p) const;
    void upload(NVGcontext* context);

    cv::Mat rgba_;
    bool changed_ = false;
    int image_ = 0;  ///< image handle of NanoVG; 0: none yet
    cv::Size image_size_;
};

}  // namespace flownav::view
