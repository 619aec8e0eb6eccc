#include "clip.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "flownav/io/output_file.h"

namespace flownav::view {

namespace {

constexpr double usual_rate_hz = 25.0;

/// Fields per second of the marked stretch.
double rate_hz(const ViewModel& model) {
    const Timeline& timeline = model.timeline();
    const auto [first, last] = model.stretch();
    if (last <= first || last >= timeline.rows.size()) return usual_rate_hz;
    const double seconds = timeline.time_s(last) - timeline.time_s(first);
    return std::clamp(static_cast<double>(last - first) / std::max(seconds, 1e-3), 1.0, 240.0);
}

}  // namespace

Clip::Clip(const ViewModel& model, std::filesystem::path file, const cv::Size& size)
    : file_(std::move(file), rate_hz(model)),
      size_(size.width / 2 * 2, size.height / 2 * 2) {  // H.264 needs even dimensions
    std::tie(next_, last_) = model.stretch();
}

bool Clip::add_next(ViewModel& model, const Look& look) {
    if (next_ > last_) return false;
    model.show(next_++);
    const cv::Mat picture = view_picture(model, look, size_);
    file_.write(picture(cv::Rect({0, 0}, size_)));
    return true;
}

void save_picture(const std::filesystem::path& file, const cv::Mat& picture) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(".png", picture, bytes);
    io::write_file(file, std::string(bytes.begin(), bytes.end()));
}

}  // namespace flownav::view
