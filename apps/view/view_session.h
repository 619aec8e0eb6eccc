#pragma once
#include <memory>
#include <ostream>
#include <string>

#include "clip.h"
#include "view_app.h"

namespace flownav::view {

/// What keys and buttons ask for.
enum class Action {
    PlayOrPause,
    Back,
    Forward,
    BackTen,
    ForwardTen,
    Home,
    End,
    Slower,
    Faster,
    Predictions,
    MarkBegin,
    MarkEnd,
    SavePicture,
    SaveClip,
    Quit,
};

/// One person at the viewer, without the window itself: what was asked for becomes calls of the model and
/// pictures; time comes from outside.
class ViewSession {
  public:
    ViewSession(ViewModel& model, const ViewCommand& command, std::ostream& out);

    /// Time has passed: plays, takes in what the background has found, writes a running clip. True when the
    /// picture has to be drawn anew.
    bool turn(double elapsed_s);

    void act(Action action);
    void set_parameter(std::size_t slider, double share);  ///< 0..1 of the slider's way
    void mouse(const cv::Point& at, bool pressed);
    void mouse_left();
    void wheel(const cv::Point& at, double clicks);
    void resize(const cv::Size& size);

    cv::Mat picture() const { return view_picture(model_, look_, size_); }
    const cv::Size& size() const { return size_; }
    const ViewModel& model() const { return model_; }
    const Look& look() const { return look_; }
    bool over() const { return over_; }
    bool saves_clip() const { return clip_ != nullptr; }

    /// Files that S and M would write next, in the current folder.
    std::string next_file(const std::string& ending) const;

  private:
    void save_picture_now();
    void begin_clip();
    void continue_clip();
    void change_speed(double factor);
    void go_where_asked();
    void print_state();

    ViewModel& model_;
    ViewCommand command_;
    std::ostream& out_;
    cv::Size size_;
    Look look_;
    std::unique_ptr<Clip> clip_;
    bool changed_ = true;
    bool over_ = false;
    double since_news_s_ = 0.0;
    bool news_ = false;
    std::string last_state_;
};

}  // namespace flownav::view
