#include "picture_widget.h"

#include <opencv2/imgproc.hpp>

namespace flownav::view {

void PictureWidget::set_picture(const cv::Mat& picture) {
    cv::cvtColor(picture, rgba_, cv::COLOR_BGR2RGBA);
    changed_ = true;
}

void PictureWidget::upload(NVGcontext* context) {
    if (image_ != 0 && image_size_ != rgba_.size()) {
        nvgDeleteImage(context, image_);
        image_ = 0;
    }
    if (image_ == 0) {
        image_ = nvgCreateImageRGBA(context, rgba_.cols, rgba_.rows, NVG_IMAGE_NEAREST, rgba_.data);
        image_size_ = rgba_.size();
    } else if (changed_) {
        nvgUpdateImage(context, image_, rgba_.data);
    }
    changed_ = false;
}

void PictureWidget::draw(NVGcontext* context) {
    if (rgba_.empty()) return;
    upload(context);
    const auto x = static_cast<float>(mPos.x());
    const auto y = static_cast<float>(mPos.y());
    const auto width = static_cast<float>(rgba_.cols);
    const auto height = static_cast<float>(rgba_.rows);
    nvgBeginPath(context);
    nvgRect(context, x, y, width, height);
    nvgFillPaint(context, nvgImagePattern(context, x, y, width, height, 0.0F, image_, 1.0F));
    nvgFill(context);
}

cv::Point PictureWidget::in_picture(const nanogui::Vector2i& p) const {
    return {p.x() - mPos.x(), p.y() - mPos.y()};
}

bool PictureWidget::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int /*modifiers*/) {
    if (button != GLFW_MOUSE_BUTTON_1) return false;
    if (down && on_mouse) on_mouse(in_picture(p), true);
    return true;
}

bool PictureWidget::mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& /*rel*/, int button,
                                     int /*modifiers*/) {
    if (on_mouse) on_mouse(in_picture(p), button != 0);
    return true;
}

bool PictureWidget::mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& /*rel*/,
                                   int /*button*/, int /*modifiers*/) {
    if (on_mouse) on_mouse(in_picture(p), true);
    return true;
}

bool PictureWidget::mouseEnterEvent(const nanogui::Vector2i& p, bool enter) {
    if (!enter && on_leave) on_leave();
    return Widget::mouseEnterEvent(p, enter);
}

bool PictureWidget::scrollEvent(const nanogui::Vector2i& p, const nanogui::Vector2f& rel) {
    if (on_wheel) on_wheel(in_picture(p), rel.y());
    return true;
}

}  // namespace flownav::view
