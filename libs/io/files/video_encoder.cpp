#include "video_encoder.h"

#include <memory>
#include <opencv2/videoio.hpp>

namespace flownav::io {

namespace {

class OpenCvEncoder : public VideoEncoder {
  public:
    bool open(const std::string& file, double rate_hz, const cv::Size& size) override {
        return writer_.open(file, cv::VideoWriter::fourcc('a', 'v', 'c', '1'), rate_hz, size);
    }
    void write(const cv::Mat& picture) override { writer_.write(picture); }
    void close() override { writer_.release(); }
    std::uint64_t pictures_in(const std::string& file) const override {
        cv::VideoCapture video(file, cv::CAP_FFMPEG);
        const double frames = video.isOpened() ? video.get(cv::CAP_PROP_FRAME_COUNT) : 0.0;
        return frames > 0.0 ? static_cast<std::uint64_t>(frames) : 0;
    }

  private:
    cv::VideoWriter writer_;
};

}  // namespace

}  // namespace flownav::io

extern "C" flownav::io::VideoEncoder* flownav_make_video_encoder();
flownav::io::VideoEncoder* flownav_make_video_encoder() {
    return std::make_unique<flownav::io::OpenCvEncoder>().release();
}
