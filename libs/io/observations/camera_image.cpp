#include "camera_image.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

namespace flownav::io {

mrpt::obs::CObservationImage::Ptr camera_image(const mrpt::obs::CObservation::Ptr& observation) {
    if (auto image = std::dynamic_pointer_cast<mrpt::obs::CObservationImage>(observation)) return image;
    const auto* depth = dynamic_cast<const mrpt::obs::CObservation3DRangeScan*>(observation.get());
    if (depth == nullptr || !depth->hasIntensityImage) return nullptr;
    auto image = mrpt::obs::CObservationImage::Create();
    image->timestamp = depth->timestamp;
    image->sensorLabel = depth->sensorLabel;
    image->image = depth->intensityImage;  // shares the pixels
    image->cameraParams = depth->cameraParamsIntensity;
    image->cameraPose = depth->sensorPose + depth->relativePoseIntensityWRTDepth;
    return image;
}

}  // namespace flownav::io
