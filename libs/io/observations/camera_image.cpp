#include "camera_image.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationStereoImages.h>

namespace flownav::io {

namespace {

mrpt::obs::CObservationImage::Ptr image_like(const mrpt::obs::CObservation& observation) {
    auto image = mrpt::obs::CObservationImage::Create();
    image->timestamp = observation.timestamp;
    image->sensorLabel = observation.sensorLabel;
    return image;
}

}  // namespace

mrpt::obs::CObservationImage::Ptr camera_image(const mrpt::obs::CObservation::Ptr& observation) {
    if (auto image = std::dynamic_pointer_cast<mrpt::obs::CObservationImage>(observation)) return image;
    if (const auto* stereo = dynamic_cast<const mrpt::obs::CObservationStereoImages*>(observation.get())) {
        auto image = image_like(*stereo);
        image->image = stereo->imageLeft;  // shares the pixels
        image->cameraParams = stereo->leftCamera;
        image->cameraPose = mrpt::poses::CPose3D(stereo->cameraPose);
        return image;
    }
    const auto* depth = dynamic_cast<const mrpt::obs::CObservation3DRangeScan*>(observation.get());
    if (depth == nullptr || !depth->hasIntensityImage) return nullptr;
    auto image = image_like(*depth);
    image->image = depth->intensityImage;  // shares the pixels
    image->cameraParams = depth->cameraParamsIntensity;
    image->cameraPose = depth->sensorPose + depth->relativePoseIntensityWRTDepth;
    return image;
}

}  // namespace flownav::io
