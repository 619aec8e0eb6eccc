#include "flownav/io/video_file.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <utility>

#include "flownav/io/camera_conversion.h"
#include "flownav/io/rawlog_reader.h"

namespace flownav::io {

struct VideoFile::Capture {
    cv::VideoCapture video;
};

VideoFile::VideoFile(const std::filesystem::path& file, config::CameraConfig camera,
                     std::optional<double> rate_hz)
    : capture_(std::make_unique<Capture>()), camera_(std::move(camera)) {
    if (!std::filesystem::exists(file)) throw InputError(file.string() + ": no such file");
    if (!std::filesystem::is_regular_file(file)) throw InputError(file.string() + ": is not a file");
    if (!capture_->video.open(file.string(), cv::CAP_FFMPEG)) {
        throw InputError(file.string() + ": cannot be read as a video");
    }
    rate_hz_ = rate_hz.value_or(capture_->video.get(cv::CAP_PROP_FPS));
    if (!(rate_hz_ > 0) || !std::isfinite(rate_hz_)) {
        throw InputError(file.string() + ": does not tell its frame rate; give it with --rate");
    }
}

VideoFile::~VideoFile() = default;

std::size_t VideoFile::size() const {
    const double frames = capture_->video.get(cv::CAP_PROP_FRAME_COUNT);
    return frames > 0 && frames < 1e9 ? static_cast<std::size_t>(frames) : 0;
}

std::optional<SequenceFrame> VideoFile::next() {
    cv::Mat image;
    if (!capture_->video.read(image) || image.empty()) return std::nullopt;
    const auto grey = std::make_shared<cv::Mat>();
    if (image.channels() == 1) {
        *grey = image.clone();
    } else {
        cv::cvtColor(image, *grey, cv::COLOR_BGR2GRAY);
    }
    Field field;
    field.timestamp_s = static_cast<double>(at_++) / rate_hz_;
    field.image = {grey->data, grey->cols, grey->rows, static_cast<std::ptrdiff_t>(grey->step)};
    field.owner = grey;
    field.camera = camera_model(camera_, grey->cols, grey->rows);
    return SequenceFrame{field, std::nullopt};
}

}  // namespace flownav::io
