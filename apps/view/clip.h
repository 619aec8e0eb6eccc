#pragma once
#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "flownav/io/video_output_file.h"
#include "view_picture.h"

namespace flownav::view {

/// A video (H.264 in MP4) of the view over a stretch of the drive, at the speed of the drive. Pictures are
/// added one by one, so that a window stays responsive.
class Clip {
  public:
    /// Exports the stretch marked in the model. Throws OutputError when `file` cannot be written.
    Clip(const ViewModel& model, std::filesystem::path file, const cv::Size& size);

    /// Shows the next field in the model and adds its picture. Returns false when all have been added.
    bool add_next(ViewModel& model, const Look& look);

    /// Completes the file. Throws OutputError when the video is incomplete, as on a full disk.
    void close() { file_.close(); }

    std::size_t pictures() const { return file_.pictures(); }
    const std::filesystem::path& file() const { return file_.path(); }

  private:
    io::VideoOutputFile file_;
    cv::Size size_;
    std::size_t next_ = 0;
    std::size_t last_ = 0;
};

/// Saves a picture as PNG. Throws OutputError.
void save_picture(const std::filesystem::path& file, const cv::Mat& picture);

}  // namespace flownav::view
