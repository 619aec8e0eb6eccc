#include "grey_image.h"

#include <opencv2/core/mat.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "flownav/io/picture_file.h"

namespace flownav::io {
namespace {

GreyImage reject(const char* reason) {
    GreyImage none;
    none.rejected = reason;
    return none;
}

ImageView view_of(const cv::Mat& pixels) {
    return {pixels.data, pixels.cols, pixels.rows, static_cast<std::ptrdiff_t>(pixels.step)};
}

GreyImage converted(const cv::Mat& pixels) {
    if (pixels.empty()) return reject("image_empty");
    if (pixels.depth() != CV_8U || pixels.channels() == 2 || pixels.channels() > 4)
        return reject("image_not_8bit");
    auto grey = std::make_shared<cv::Mat>();
    if (pixels.channels() == 1) *grey = pixels;
    if (pixels.channels() == 3) cv::cvtColor(pixels, *grey, cv::COLOR_BGR2GRAY);
    if (pixels.channels() == 4) cv::cvtColor(pixels, *grey, cv::COLOR_BGRA2GRAY);
    return {view_of(*grey), grey, ""};
}

GreyImage load(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return reject("image_missing");
    const cv::Mat pixels = read_picture(file, cv::IMREAD_UNCHANGED);
    return pixels.empty() ? reject("image_unreadable") : converted(pixels);
}

}  // namespace

GreyImage grey_image(const mrpt::obs::CObservationImage::Ptr& image,
                     const std::filesystem::path& images_directory) {
    const mrpt::img::CImage& recorded = image->image;
    if (recorded.isExternallyStored()) return load(images_directory / recorded.getExternalStorageFile());
    if (recorded.isEmpty()) return reject("image_empty");
    const cv::Mat& pixels = recorded.asCvMatRef();
    if (pixels.type() == CV_8UC1 && !pixels.empty()) return {view_of(pixels), image, ""};
    return converted(pixels);
}

}  // namespace flownav::io
