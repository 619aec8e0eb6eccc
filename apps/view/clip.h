#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>

#include "view_picture.h"

namespace cv {
class VideoWriter;
}

namespace flownav::view {

/// A stretch of the drive as a video (H.264 in MP4) of the view, as fast as the drive was. Field by field, so
/// that a window stays alive meanwhile.
class Clip {
  public:
    /// The stretch that is marked in the model. Throws OutputError when `file` cannot be written.
    Clip(const ViewModel& model, std::filesystem::path file, const cv::Size& size);
    ~Clip();
    Clip(const Clip&) = delete;
    Clip& operator=(const Clip&) = delete;

    /// Shows the next field in the model and adds its picture; false when all have been added.
    bool add_next(ViewModel& model, const Look& look);

    /// Completes the file. Throws OutputError when it did not become a whole video, as on a full disk.
    void close();

    std::size_t pictures() const { return pictures_; }
    const std::filesystem::path& file() const { return file_; }

  private:
    std::filesystem::path file_;
    cv::Size size_;
    std::size_t next_ = 0;
    std::size_t last_ = 0;
    std::size_t pictures_ = 0;
    std::unique_ptr<cv::VideoWriter> writer_;
};

/// Saves a picture as PNG. Throws OutputError.
void save_picture(const std::filesystem::path& file, const cv::Mat& picture);

}  // namespace flownav::view
