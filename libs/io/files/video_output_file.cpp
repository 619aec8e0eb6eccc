#include "flownav/io/video_output_file.h"

#include <dlfcn.h>

#include <utility>

#include "flownav/io/output_file.h"
#include "video_encoder.h"

namespace flownav::io {

namespace {

/// Loads the module, which is never unloaded because FFmpeg's libraries do not support it. Throws
/// OutputError.
std::unique_ptr<VideoEncoder> load_encoder(const std::filesystem::path& file) {
    void* module = dlopen(FLOWNAV_VIDEO_MODULE, RTLD_NOW | RTLD_LOCAL);
    void* make = module != nullptr ? dlsym(module, make_video_encoder_symbol) : nullptr;
    if (make == nullptr) throw OutputError("cannot write " + file.string() + ": " + dlerror());
    return std::unique_ptr<VideoEncoder>(reinterpret_cast<MakeVideoEncoder*>(make)());
}

}  // namespace

VideoOutputFile::VideoOutputFile(std::filesystem::path file, double rate_hz)
    : path_(std::move(file)), rate_hz_(rate_hz) {
    write_file(path_, "");  // throws at once, with the reason, when the file cannot be written
}

VideoOutputFile::~VideoOutputFile() = default;

void VideoOutputFile::write(const cv::Mat& picture) {
    if (!encoder_) {
        encoder_ = load_encoder(path_);
        if (!encoder_->open(path_.string(), rate_hz_, picture.size()))
            throw OutputError("cannot write " + path_.string() + ": OpenCV has no H.264 encoder for it");
    }
    encoder_->write(picture);
    ++pictures_;
}

void VideoOutputFile::close() {
    if (!encoder_) return;
    encoder_->close();
    // OpenCV reports no write errors; a truncated video cannot be opened, or holds too few pictures.
    if (encoder_->pictures_in(path_.string()) != pictures_)
        throw OutputError("cannot write " + path_.string() + ": the video is not whole; is the disk full?");
}

}  // namespace flownav::io
