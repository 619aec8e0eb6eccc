#include <cmath>

#include "flownav/io/errors.h"
#include "flownav/io/kitti.h"
#include "flownav/math/units.h"
#include "grey_pictures.h"
#include "import_files.h"

namespace flownav::io {
namespace {

std::size_t number_of(const std::filesystem::path& image) {
    const std::string stem = image.stem().string();
    if (stem.empty() || stem.size() > 18 || stem.find_first_not_of("0123456789") != std::string::npos) {
        throw InputError(image.string() + ": the name of an image has to be its number");
    }
    return std::stoull(stem);
}

}  // namespace

KittiImages::KittiImages() = default;
KittiImages::~KittiImages() = default;

void KittiImages::take_images(const std::filesystem::path& folder) {
    images_ = list_images(folder);
    for (const auto& image : images_) number_of(image);
    pictures_ = std::make_unique<GreyPictures>(images_);
    if (!pictures_->note().empty()) add_note(folder.string() + ": " + pictures_->note());
}

std::size_t KittiImages::numbers() const {
    return number_of(images_.back()) + 1;
}

void KittiImages::tell_missing_images() {
    std::vector<bool> there(std::max(numbers(), times_s_.size()), false);
    for (const auto& image : images_) there[number_of(image)] = true;
    std::size_t missing = 0;
    std::size_t first = 0;
    for (std::size_t i = there.size(); i-- > 0;) {
        if (there[i]) continue;
        ++missing;
        first = i;
    }
    if (missing == 0) return;
    add_problem(images_.front().parent_path().string() + ": " + std::to_string(missing) + " of " +
                std::to_string(there.size()) + " images are missing, the first is number " +
                std::to_string(first) + "; the others keep their times");
}

std::optional<SequenceFrame> KittiImages::next() {
    while (at_ < images_.size()) {
        const std::filesystem::path& image = images_[at_++];
        const std::size_t number = number_of(image);
        if (number >= times_s_.size() || !times_s_[number]) {
            add_problem(image.string() + ": is left out, there is no time for it");
            continue;
        }
        if (last_s_ && *times_s_[number] <= *last_s_) {
            add_problem(image.string() +
                        ": is left out, its time is not later than that of the image before");
            continue;
        }
        auto field = pictures_->load(image);
        if (!field) {
            add_problem(pictures_->why());
            continue;
        }
        last_s_ = times_s_[number];
        field->timestamp_s = *times_s_[number];
        field->camera = camera_;
        field->camera.width_px = field->image.width_px;
        field->camera.height_px = field->image.height_px;
        SequenceFrame frame{*field, std::nullopt};
        if (number < T_start_robot_.size()) frame.T_start_robot = T_start_robot_[number];
        return frame;
    }
    return std::nullopt;
}

}  // namespace flownav::io
