#pragma once
#include <mrpt/obs/CObservationImage.h>

#include <filesystem>
#include <memory>
#include <string>

#include "flownav/core/image_view.h"

namespace flownav::io {

/// The 8-bit grey pixels of a recorded image, or the reason for its rejection.
struct GreyImage {
    ImageView view;
    std::shared_ptr<const void> owner;
    std::string rejected;  ///< empty, image_missing, image_unreadable, image_empty or image_not_8bit
};

/// Returns the grey pixels of an image. Shares the pixels of embedded 8-bit grey images, converts colour, and
/// loads external images; their relative names refer to `images_directory`.
GreyImage grey_image(const mrpt::obs::CObservationImage::Ptr& image,
                     const std::filesystem::path& images_directory);

}  // namespace flownav::io
