#include "video_images.h"

#include <cmath>
#include <sstream>

#include "flownav/io/errors.h"

namespace flownav::io {
namespace {

std::string text_of(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

}  // namespace

VideoImages::VideoImages(const std::filesystem::path& file, std::optional<double> rate_hz,
                         const char* rate_option)
    : file_(file), decoder_(file) {
    const VideoFacts& facts = decoder_.facts();
    constant_rate_ = rate_hz || !facts.has_times;
    rate_hz_ = rate_hz.value_or(facts.rate_hz.value_or(0.0));
    if (constant_rate_ && !(rate_hz_ > 0))
        throw InputError(file.string() + ": does not tell the times of its images; give their rate with " +
                         rate_option);
    if (rate_hz && facts.rate_hz && std::abs(*rate_hz - *facts.rate_hz) > 0.01 * *facts.rate_hz)
        notes_.push_back(file.string() + ": tells " + text_of(*facts.rate_hz) + " images a second; " +
                         rate_option + " " + text_of(*rate_hz) + " is used instead of its time stamps");
    if (facts.turn_deg != 0)
        notes_.push_back(
            file.string() + ": its images are turned clockwise by " + std::to_string(facts.turn_deg) +
            " degrees, as its rotation tag says; the calibration has to be that of the turned images");
    if (facts.odd_rotation)
        notes_.push_back(file.string() +
                         ": its rotation tag mirrors the images or turns them by no quarter turn; it is not "
                         "followed");
}

/// Time of an image after the first; empty when it is not later than the image before.
std::optional<double> VideoImages::time_of(const VideoImage& image) {
    if (constant_rate_) return static_cast<double>(images_) / rate_hz_;
    double time_s = 0.0;
    if (image.time_s) {
        if (!first_s_) first_s_ = image.time_s;
        time_s = *image.time_s - *first_s_;
    } else {
        ++unstamped_;
        const double period_s = period_s_ > 0 ? period_s_ : (rate_hz_ > 0 ? 1.0 / rate_hz_ : 0.04);
        time_s = last_s_ ? *last_s_ + period_s : 0.0;
    }
    if (last_s_ && time_s <= *last_s_) return std::nullopt;
    if (last_s_) period_s_ = time_s - *last_s_;
    return time_s;
}

std::optional<Field> VideoImages::next() {
    while (auto image = decoder_.next()) {
        interlaced_ += image->interlaced ? 1 : 0;
        top_first_ += image->interlaced && image->top_field_first ? 1 : 0;
        if (width_px_ == 0) {
            width_px_ = image->grey.cols;
            height_px_ = image->grey.rows;
        }
        const auto time_s = time_of(*image);
        if (!time_s || image->grey.cols != width_px_ || image->grey.rows != height_px_) {
            ++(time_s ? other_size_ : not_rising_);
            continue;
        }
        ++images_;
        last_s_ = time_s;
        const auto grey = std::make_shared<cv::Mat>(std::move(image->grey));
        Field field;
        field.timestamp_s = *time_s;
        field.image = {grey->data, grey->cols, grey->rows, static_cast<std::ptrdiff_t>(grey->step)};
        field.owner = grey;
        return field;
    }
    if (!finished_) finish();
    return std::nullopt;
}

void VideoImages::finish() {
    finished_ = true;
    const std::string name = file_.string() + ": ";
    const std::string cut_short = decoder_.cut_short();
    if (!cut_short.empty()) problems_.push_back(name + cut_short);
    if (decoder_.damaged() > 0)
        problems_.push_back(name + std::to_string(decoder_.damaged()) +
                            " images are damaged and are left out");
    if (not_rising_ > 0)
        problems_.push_back(
            name + std::to_string(not_rising_) +
            " images have a time stamp that is not later than the one before and are left out; a "
            "constant rate (--rate, rate_hz) would date them all");
    if (other_size_ > 0)
        problems_.push_back(name + std::to_string(other_size_) +
                            " images have another size than the first, " + std::to_string(width_px_) + " x " +
                            std::to_string(height_px_) + " pixels, and are left out");
    if (constant_rate_ || images_ < 2) return;
    const double period_s = *last_s_ / static_cast<double>(images_ - 1);
    if (period_s < 0.0005)
        problems_.push_back(
            name + "its images are " + text_of(period_s) +
            " s apart by their time stamps, as no camera takes them; give their rate (--rate, "
            "rate_hz)");
    if (period_s > 0.5)
        notes_.push_back(name + "the images are " + text_of(period_s) +
                         " s apart: a replay needs motion.gap_max_s above that (default 0.5)");
    if (unstamped_ > 0)
        notes_.push_back(name + std::to_string(unstamped_) +
                         " images have no time stamp; each is dated one period after the one before");
}

std::string VideoImages::advice(config::Interlaced configured) const {
    if (2 * interlaced_ <= images_) return "";
    const bool top = 2 * top_first_ >= interlaced_;
    const auto flagged = top ? config::Interlaced::TopFirst : config::Interlaced::BottomFirst;
    if (configured == flagged) return "";
    const std::string order = top ? "top_first" : "bottom_first";
    return file_.string() + ": its images are marked as two woven fields each, " +
           (top ? "the top" : "the bottom") +
           " field first; if that is so, set camera.interlaced = " + order + " (--interlaced " + order + ")";
}

}  // namespace flownav::io
