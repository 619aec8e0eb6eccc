#include "flownav/io/video_output_file.h"

#include <dlfcn.h>

#include <utility>

#include "flownav/io/output_file.h"
#include "video_encoder.h"

namespace flownav::io {

namespace {

/// It stays loaded: FFmpeg's libraries are not made to be unloaded.
std::unique_ptr<VideoEncoder> load_encoder(const std::filesystem::path& file) {
    void* module = dlopen(FLOWNAV_VIDEO_MODULE, RTLD_NOW | RTLD_LOCAL);
    void* make = module != nullptr ? dlsym(module, make_video_encoder_symbol) : nullptr;
    if (make == nullptr) throw OutputError("cannot write " + file.string() + ": " + dlerror());
    return std::unique_ptr<VideoEncoder>(reinterpret_cast<MakeVideoEncoder*>(make)());
}

}  // namespace

VideoOutputFile::VideoOutputFile(std::filesystem::path file, double rate_hz)
    : path_(std::move(file)), rate_hz_(rate_hz) {
    write_file(path_, "");  // says at once, and why, when it cannot be written
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
    // OpenCV reports no error while it writes; a cut video cannot be opened, or counts too few pictures.
    if (encoder_->pictures_in(path_.string()) != pictures_)
        throw OutputError("cannot write " + path_.string() + ": the video is not whole; is the disk full?");
}

}  // namespace flownav::io
