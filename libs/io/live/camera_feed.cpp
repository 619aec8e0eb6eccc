#include "camera_feed.h"

#include <mrpt/core/exceptions.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>

#include <utility>
#include <vector>

#include "file_feeds.h"
#include "flownav/io/rawlog_reader.h"

namespace flownav::io {
namespace {

using mrpt::obs::CObservation;

std::string plain_message(const std::exception& error) {
    const auto* mrpt_error = dynamic_cast<const mrpt::ExceptionWithCallBackBase*>(&error);
    return mrpt_error != nullptr ? mrpt_error->originalWhat : error.what();
}

bool has_picture(const CObservation& observation) {
    return dynamic_cast<const mrpt::obs::CObservationImage*>(&observation) != nullptr ||
           dynamic_cast<const mrpt::obs::CObservation3DRangeScan*>(&observation) != nullptr;
}

}  // namespace

CameraFeed::CameraFeed(ProducerSettings settings) : settings_(std::move(settings)) {}

void CameraFeed::open() {
    try {
        camera_.loadConfig(camera_section(settings_), "camera");
        camera_.initialize();
    } catch (const std::exception& error) {
        throw InputError(settings_.source + ": cannot be opened: " + plain_message(error));
    }
}

CObservation::Ptr CameraFeed::next() {
    CObservation::Ptr observation;
    try {
        observation = picture();
    } catch (const std::exception& error) {
        fail(place() + ": " + plain_message(error));
    }
    if (!observation) return nullptr;
    observation->sensorLabel = settings_.config.camera.camera_label;
    ++images_;
    return observation;
}

std::string CameraFeed::place() const {
    return place_after(settings_.source, images_);
}

CObservation::Ptr CameraFeed::picture() {
    std::vector<mrpt::serialization::CSerializable::Ptr> out;
    camera_.getNextFrame(out);  // the overload that returns one observation crashes at the end of a video
    for (const auto& object : out) {
        auto observation = std::dynamic_pointer_cast<CObservation>(object);
        if (observation && has_picture(*observation)) return observation;
    }
    if (out.empty() || !out.front()) {
        fail(place() + ": no image comes any more: device gone, or end of the stream");
    } else {
        fail(settings_.source + ": gives " + out.front()->GetRuntimeClass()->className +
             ", which holds no single picture");
    }
    return nullptr;
}

mrpt::config::CConfigFileMemory camera_section(const ProducerSettings& settings) {
    std::string text = "[camera]\nprocess_rate = 1\n";
    for (const auto& [key, value] : settings.camera_keys)
        text.append(key).append(" = ").append(value) += '\n';
    return {text};
}

std::string place_after(const std::string& source, std::uint64_t images) {
    return source + ", after " + std::to_string(images) + (images == 1 ? " image" : " images");
}

std::unique_ptr<FieldFeed> open_camera(const ProducerSettings& settings) {
    const std::string scheme = "file://";
    const std::string& source = settings.source;
    const bool file_url = source.rfind(scheme, 0) == 0;
    const bool stream = !file_url && source.find("://") != std::string::npos;
    if (settings.grabber_type == "image_dir") return make_folder_feed(settings);
    if (settings.grabber_type == "ffmpeg" && !stream)
        return make_video_feed(settings, file_url ? source.substr(scheme.size()) : source);
    auto feed = std::make_unique<CameraFeed>(settings);
    feed->open();
    return feed;
}

}  // namespace flownav::io
