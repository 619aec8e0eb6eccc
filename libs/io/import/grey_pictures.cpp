#include "grey_pictures.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "flownav/io/picture_file.h"

namespace flownav::io {
namespace {

constexpr int flags = cv::IMREAD_GRAYSCALE | cv::IMREAD_ANYDEPTH;
constexpr std::size_t sample_size = 64;

/// Bits that hold the brightest pixel: 8, 10, 12, 14 or 16.
int bits_of(double brightest) {
    int bits = 8;
    while (bits < 16 && brightest >= static_cast<double>(1 << bits)) bits += 2;
    return bits;
}

double full_scale(int bits) {
    return static_cast<double>((1 << bits) - 1);
}

}  // namespace

GreyPictures::GreyPictures(const std::vector<std::filesystem::path>& pictures) {
    double brightest = 0.0;
    for (std::size_t i = 0; i < sample_size; ++i) {
        const std::size_t index = i * pictures.size() / sample_size;
        if (i > 0 && index == (i - 1) * pictures.size() / sample_size) continue;
        const cv::Mat pixels = read_picture(pictures[index], flags);
        if (pixels.type() != CV_16UC1 || pixels.empty()) {
            if (!pixels.empty()) break;
            continue;
        }
        deep_ = true;
        double most = 0.0;
        cv::minMaxLoc(pixels, nullptr, &most);
        brightest = std::max(brightest, most);
    }
    bits_ = bits_of(brightest);
}

std::optional<Field> GreyPictures::load(const std::filesystem::path& file) {
    const auto pixels = std::make_shared<cv::Mat>(read_picture(file, flags));
    const auto fail = [&](const std::string& reason) {
        why_ = file.string() + ": " + reason;
        return std::nullopt;
    };
    if (pixels->empty()) return fail("cannot be read as a picture; it is damaged or cut short");
    if (pixels->type() == CV_16UC1) {
        double most = 0.0;
        cv::minMaxLoc(*pixels, nullptr, &most);
        if (most > full_scale(bits_)) ++brighter_;
        pixels->convertTo(*pixels, CV_8U, 255.0 / full_scale(bits_));
    }
    if (pixels->type() != CV_8UC1) return fail("is no picture of 8 or 16 bits");
    if (width_px_ == 0) {
        width_px_ = pixels->cols;
        height_px_ = pixels->rows;
    }
    if (pixels->cols != width_px_ || pixels->rows != height_px_) {
        return fail("has " + std::to_string(pixels->cols) + " x " + std::to_string(pixels->rows) +
                    " pixels, the pictures before have " + std::to_string(width_px_) + " x " +
                    std::to_string(height_px_));
    }
    Field field;
    field.image = {pixels->data, pixels->cols, pixels->rows, static_cast<std::ptrdiff_t>(pixels->step)};
    field.owner = pixels;
    return field;
}

std::string GreyPictures::note() const {
    if (!deep_) return "";
    return "the pictures have 16 bits and use " + std::to_string(bits_) + " of them; these are scaled to 8";
}

std::string GreyPictures::brighter() const {
    if (brighter_ == 0) return "";
    return std::to_string(brighter_) + " pictures are in parts brighter than the " + std::to_string(bits_) +
           " bits that the others use; these parts are white";
}

}  // namespace flownav::io
