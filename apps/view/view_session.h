#pragma once
#include <memory>
#include <ostream>
#include <string>

#include "clip.h"
#include "view_app.h"

namespace flownav::view {

/// Actions of keys and buttons.
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
    Contacts,
    MarkBegin,
    MarkEnd,
    SavePicture,
    SaveClip,
    Quit,
};

/// The user interface without its window: converts actions to calls of the model and to pictures. Time is
/// passed in.
class ViewSession {
  public:
    ViewSession(ViewModel& model, const ViewCommand& command, std::ostream& out);

    /// Advances by `elapsed_s`: plays, takes in the results of the background, writes a running clip. Returns
    /// true when the picture must be redrawn.
    bool turn(double elapsed_s);

    void act(Action action);
    void set_parameter(std::size_t slider, double share);  ///< `share`: 0..1 along the slider
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

    /// Name of the file that S or M would write next, in the current folder.
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
