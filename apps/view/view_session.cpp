#include "view_session.h"

#include <algorithm>
#include <cmath>

#include "flownav/cli/number_text.h"
#include "flownav/io/output_file.h"
#include "sliders.h"
#include "state_json.h"
#include "strip_panel.h"

namespace flownav::view {

namespace {

constexpr double news_every_s = 0.25;  // update period of the chart while the background reads
constexpr double slowest = 1.0 / 16;
constexpr double fastest = 16.0;
constexpr double least_ahead_m = 1.0;
constexpr double most_ahead_m = 100.0;

}  // namespace

ViewSession::ViewSession(ViewModel& model, const ViewCommand& command, std::ostream& out)
    : model_(model), command_(command), out_(out), size_(command.size), look_(look_for(model.config())) {
    if (!model.follows()) return;
    model_.show(model_.last_index());
    model_.set_playing(true);
}

bool ViewSession::turn(double elapsed_s) {
    const std::size_t before = model_.frame().index;
    if (command_.problem && look_.note.empty()) look_.note = command_.problem();
    const bool preview = model_.frame().preview;
    news_ = model_.poll() || news_;
    since_news_s_ += elapsed_s;
    go_where_asked();
    if (clip_) {
        continue_clip();
    } else {
        model_.play_for(elapsed_s);
    }
    if (news_ && (since_news_s_ >= news_every_s || model_.timeline().complete)) {
        since_news_s_ = 0.0;
        news_ = false;
        changed_ = true;
    }
    changed_ = changed_ || model_.frame().index != before || model_.frame().preview != preview;
    print_state();
    return std::exchange(changed_, false);
}

void ViewSession::act(Action action) {
    look_.note.clear();
    changed_ = true;
    switch (action) {
        case Action::PlayOrPause:
            return model_.set_playing(!model_.playing());
        case Action::Back:
            return model_.step_by(-1);
        case Action::Forward:
            return model_.step_by(1);
        case Action::BackTen:
            return model_.step_by(-10);
        case Action::ForwardTen:
            return model_.step_by(10);
        case Action::Home:
            return model_.step_by(-static_cast<int>(model_.frame().index));
        case Action::End:
            return model_.step_by(static_cast<int>(model_.timeline().rows.size()));
        case Action::Slower:
            return change_speed(0.5);
        case Action::Faster:
            return change_speed(2.0);
        case Action::Predictions:
            look_.predictions = !look_.predictions;
            return;
        case Action::Contacts:
            look_.contacts = !look_.contacts;
            return;
        case Action::MarkBegin:
            return model_.mark_begin();
        case Action::MarkEnd:
            return model_.mark_end();
        case Action::SavePicture:
            return save_picture_now();
        case Action::SaveClip:
            return begin_clip();
        case Action::Quit:
            over_ = true;
    }
}

void ViewSession::change_speed(double factor) {
    model_.set_speed(std::clamp(model_.speed() * factor, slowest, fastest));
    look_.note = "speed x " + cli::fixed_text(model_.speed(), model_.speed() < 1.0 ? 3 : 0);
}

void ViewSession::set_parameter(std::size_t slider, double share) {
    const SliderKey& key = slider_keys().at(slider);
    const std::string text = slider_text(key, share);
    const std::string now = slider_text(key, slider_share(key, model_.config()));
    if (text == now) return;
    look_.note.clear();
    model_.set(key.key, text);
    changed_ = true;
}

void ViewSession::mouse(const cv::Point& at, bool pressed) {
    const ViewLayout layout = layout_of(model_, size_);
    if (pressed && layout.strip.contains(at) && !clip_) {
        model_.set_playing(false);
        model_.show_at(strip_time_s(model_.timeline(), at.x - layout.strip.x, layout.strip.width));
        changed_ = true;
    }
    const auto before = model_.hovered_block();
    model_.hover(field_px_under(model_, size_, at));
    changed_ = changed_ || model_.hovered_block() != before;
}

void ViewSession::mouse_left() {
    changed_ = changed_ || model_.hovered_block();
    model_.hover(std::nullopt);
}

void ViewSession::wheel(const cv::Point& at, double clicks) {
    if (!layout_of(model_, size_).map.contains(at)) return;
    look_.ahead_m = std::clamp(look_.ahead_m * std::pow(0.8, clicks), least_ahead_m, most_ahead_m);
    changed_ = true;
}

void ViewSession::resize(const cv::Size& size) {
    const cv::Size usable(std::max(size.width, least_width_px), std::max(size.height, least_height_px));
    changed_ = changed_ || usable != size_;
    if (!clip_) size_ = usable;
}

std::string ViewSession::next_file(const std::string& ending) const {
    const std::string stem = std::filesystem::path(model_.name()).stem().string();
    for (int i = 1;; ++i) {
        std::string file = stem;
        file.append("-view-").append(std::to_string(i)).append(ending);
        if (!std::filesystem::exists(file)) return file;
    }
}

void ViewSession::save_picture_now() {
    const std::string file = next_file(".png");
    try {
        save_picture(file, picture());
        look_.note = "saved " + file;
    } catch (const io::OutputError& error) {
        look_.note = error.what();
    }
}

void ViewSession::begin_clip() {
    if (clip_ || model_.timeline().rows.empty()) return;
    model_.set_playing(false);
    try {
        clip_ = std::make_unique<Clip>(model_, next_file(".mp4"), size_);
    } catch (const io::OutputError& error) {
        look_.note = error.what();
    }
}

void ViewSession::continue_clip() {
    changed_ = true;
    try {
        if (clip_->add_next(model_, look_)) return;
        clip_->close();
        look_.note =
            "saved " + clip_->file().string() + ", " + std::to_string(clip_->pictures()) + " pictures";
    } catch (const io::OutputError& error) {
        look_.note = error.what();
    }
    clip_.reset();
}

/// Shows the field of --at as soon as the background has read it.
void ViewSession::go_where_asked() {
    const Timeline& timeline = model_.timeline();
    if (command_.at_s <= 0.0 || timeline.rows.empty()) return;
    if (!timeline.complete && timeline.time_s(model_.last_index()) < command_.at_s) return;
    model_.show_at(command_.at_s);
    command_.at_s = 0.0;
}

void ViewSession::print_state() {
    if (!command_.print_state || !changed_) return;
    const std::string state = state_json(model_);
    if (state == last_state_) return;
    out_ << state << '\n' << std::flush;
    last_state_ = state;
}

}  // namespace flownav::view
