#include "flownav/io/kitti.h"
#include "flownav/io/rawlog_reader.h"
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

std::optional<SequenceFrame> KittiImages::next() {
    while (at_ < images_.size()) {
        const std::filesystem::path& image = images_[at_++];
        const std::size_t number = number_of(image);
        if (number >= times_s_.size()) {
            add_problem(image.string() + ": there is no time for it, only " +
                        std::to_string(times_s_.size()));
            continue;
        }
        auto field = load_grey(image);
        if (!field) {
            add_problem(image.string() + ": cannot be read as a picture");
            continue;
        }
        field->timestamp_s = times_s_[number];
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
