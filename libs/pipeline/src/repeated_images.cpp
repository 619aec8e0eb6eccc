#include "flownav/pipeline/repeated_images.h"

#include <functional>
#include <string_view>

namespace flownav::pipeline {
namespace {

std::size_t digest_of(const ImageView& image) {
    std::size_t digest = 0;
    for (int v = 0; v < image.height_px; ++v) {
        const std::string_view row(reinterpret_cast<const char*>(image.row(v)),
                                   static_cast<std::size_t>(image.width_px));
        digest = digest * 31 + std::hash<std::string_view>()(row);
    }
    return digest;
}

}  // namespace

bool RepeatedImages::is_repeated(const ImageView& image) {
    if (image.empty()) return false;
    const std::size_t digest = digest_of(image);
    const bool repeated = digest == before_[0] || digest == before_[1];
    before_ = {digest, before_[0]};
    return repeated;
}

}  // namespace flownav::pipeline
