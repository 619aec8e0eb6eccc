#include "flownav/replay/no_field.h"

namespace flownav {

namespace {

/// "a (3), b (1)"
std::string listed(const std::map<std::string, std::uint64_t>& counts) {
    std::string text;
    for (const auto& [name, count] : counts) {
        text += (text.empty() ? "" : ", ") + name + " (" + std::to_string(count) + ')';
    }
    return text;
}

}  // namespace

std::string no_field_message(const std::filesystem::path& input, const InputCounts& read,
                             const CameraConfig& camera) {
    const std::string message = "no field could be used in " + input.string() + ": ";
    if (read.images > 0) return message + "all images were rejected: " + listed(read.rejected);
    if (read.observations.empty()) return message + "it holds no observation";
    return message + "it has no image labelled " + camera.camera_label + " but " + listed(read.observations) +
           "; set camera.camera_label";
}

}  // namespace flownav
