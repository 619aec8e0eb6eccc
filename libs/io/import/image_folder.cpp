#include "flownav/io/image_folder.h"

#include <utility>

#include "flownav/io/camera_conversion.h"
#include "grey_pictures.h"
#include "image_times.h"
#include "import_files.h"

namespace flownav::io {

ImageFolder::ImageFolder(const std::filesystem::path& directory, config::CameraConfig camera,
                         const FrameTimes& times)
    : camera_(std::move(camera)) {
    const auto images = list_images(directory);
    schedule_ = std::make_unique<ImageSchedule>(schedule_images(directory, images, times));
    pictures_ = std::make_unique<GreyPictures>(images);
    for (const std::string& note : schedule_->notes) add_note(note);
    for (const std::string& problem : schedule_->problems) add_problem(problem);
    if (!pictures_->note().empty()) add_note(directory.string() + ": " + pictures_->note());
}

ImageFolder::~ImageFolder() = default;

std::size_t ImageFolder::size() const {
    return schedule_->images.size();
}

std::vector<GyroRate> ImageFolder::gyro() const {
    return schedule_->gyro;
}

const std::string& ImageFolder::times_source() const {
    return schedule_->source;
}

std::optional<SequenceFrame> ImageFolder::next() {
    while (at_ < schedule_->images.size()) {
        const TimedImage& image = schedule_->images[at_++];
        auto field = pictures_->load(image.file);
        if (!field) {
            add_problem(pictures_->why());
            continue;
        }
        field->timestamp_s = image.time_s;
        field->camera = camera_model(camera_, field->image.width_px, field->image.height_px);
        return SequenceFrame{*field, std::nullopt};
    }
    if (at_++ == schedule_->images.size() && !pictures_->brighter().empty()) add_note(pictures_->brighter());
    return std::nullopt;
}

}  // namespace flownav::io
