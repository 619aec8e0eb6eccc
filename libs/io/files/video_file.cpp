#include "flownav/io/video_file.h"

#include <utility>

#include "flownav/io/camera_conversion.h"
#include "video_images.h"

namespace flownav::io {

VideoFile::VideoFile(const std::filesystem::path& file, config::CameraConfig camera,
                     std::optional<double> rate_hz)
    : images_(std::make_unique<VideoImages>(file, rate_hz, "--rate")), camera_(std::move(camera)) {}

VideoFile::~VideoFile() = default;

std::size_t VideoFile::size() const {
    return images_->size();
}

std::optional<SequenceFrame> VideoFile::next() {
    auto field = images_->next();
    if (field) {
        field->camera = camera_model(camera_, field->image.width_px, field->image.height_px);
        return SequenceFrame{*field, std::nullopt};
    }
    if (std::exchange(told_, true)) return std::nullopt;
    for (const std::string& note : images_->notes()) add_note(note);
    for (const std::string& problem : images_->problems()) add_problem(problem);
    const std::string advice = images_->advice(camera_.interlaced);
    if (!advice.empty()) add_note(advice);
    return std::nullopt;
}

}  // namespace flownav::io
