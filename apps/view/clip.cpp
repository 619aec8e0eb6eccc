#include "clip.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "flownav/replay/output_file.h"

namespace flownav::view {

namespace {

constexpr double usual_rate_hz = 25.0;

/// Fields a second over the stretch.
double rate_hz(const Timeline& timeline, std::size_t first, std::size_t last) {
    if (last <= first || last >= timeline.rows.size()) return usual_rate_hz;
    const double seconds = timeline.time_s(last) - timeline.time_s(first);
    return std::clamp(static_cast<double>(last - first) / std::max(seconds, 1e-3), 1.0, 240.0);
}

}  // namespace

Clip::Clip(const ViewModel& model, std::filesystem::path file, const cv::Size& size)
    : file_(std::move(file)),
      size_(size.width / 2 * 2, size.height / 2 * 2),  // H.264 wants even numbers
      writer_(std::make_unique<cv::VideoWriter>()) {
    std::tie(next_, last_) = model.stretch();
    write_file(file_, "");  // says at once, and why, when it cannot be written
    const int code = cv::VideoWriter::fourcc('a', 'v', 'c', '1');
    if (!writer_->open(file_.string(), code, rate_hz(model.timeline(), next_, last_), size_)) {
        throw OutputError("cannot write " + file_.string() + ": OpenCV has no H.264 encoder for it");
    }
}

Clip::~Clip() = default;

bool Clip::add_next(ViewModel& model, const Look& look) {
    if (next_ > last_) return false;
    model.show(next_++);
    const cv::Mat picture = view_picture(model, look, size_);
    writer_->write(picture(cv::Rect({0, 0}, size_)));
    ++pictures_;
    return true;
}

void Clip::close() {
    writer_->release();
    // OpenCV reports no error while it writes; a cut video cannot be opened, or counts too few pictures.
    cv::VideoCapture check(file_.string(), cv::CAP_FFMPEG);
    const bool whole =
        check.isOpened() && check.get(cv::CAP_PROP_FRAME_COUNT) == static_cast<double>(pictures_);
    if (!whole)
        throw OutputError("cannot write " + file_.string() + ": the video is not whole; is the disk full?");
}

void save_picture(const std::filesystem::path& file, const cv::Mat& picture) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(".png", picture, bytes);
    write_file(file, std::string(bytes.begin(), bytes.end()));
}

}  // namespace flownav::view
