#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/core/Clock.h>
#include <mrpt/core/exceptions.h>
#include <mrpt/hwdrivers/CCameraSensor.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/videoio.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "field_feed.h"
#include "flownav/replay/rawlog_reader.h"
#include "numbered_files.h"

namespace flownav::producer {
namespace {

using mrpt::hwdrivers::CCameraSensor;
using mrpt::obs::CObservation;

std::string plain_message(const std::exception& error) {
    const auto* mrpt_error = dynamic_cast<const mrpt::ExceptionWithCallBackBase*>(&error);
    return mrpt_error != nullptr ? mrpt_error->originalWhat : error.what();
}

std::string key_of(const ProducerSettings& settings, const std::string& key, const std::string& otherwise) {
    const auto found = settings.camera_keys.find(key);
    return found == settings.camera_keys.end() ? otherwise : found->second;
}

bool has_picture(const CObservation& observation) {
    return dynamic_cast<const mrpt::obs::CObservationImage*>(&observation) != nullptr ||
           dynamic_cast<const mrpt::obs::CObservation3DRangeScan*>(&observation) != nullptr;
}

/// Whatever CCameraSensor can open. Cameras and streams never end regularly.
class CameraFeed : public FieldFeed {
  public:
    explicit CameraFeed(ProducerSettings settings) : settings_(std::move(settings)) {}

    void open() {
        try {
            camera_.loadConfig(section(), "camera");
            camera_.initialize();
        } catch (const std::exception& error) {
            throw InputError(settings_.source + ": cannot be opened: " + plain_message(error));
        }
    }

    CObservation::Ptr next() override {
        if (at_end()) return nullptr;
        CObservation::Ptr observation;
        try {
            observation = picture();
        } catch (const std::exception& error) {
            fail(place() + ": " + plain_message(error));
        }
        if (!observation) return nullptr;
        observation->sensorLabel = settings_.config.camera.camera_label;
        if (const auto time_s = timestamp_s()) observation->timestamp = mrpt::Clock::fromDouble(*time_s);
        ++images_;
        return observation;
    }

  protected:
    /// True at a regular end; may also fail() instead of running into what MRPT would do.
    virtual bool at_end() { return false; }

    /// Of the image that comes; nothing: the grabber's own.
    virtual std::optional<double> timestamp_s() const { return std::nullopt; }

    /// MRPT gives nothing more.
    virtual void run_dry() { fail(place() + ": no image comes any more: device gone, or end of the stream"); }

    const ProducerSettings& settings() const { return settings_; }
    std::uint64_t images() const { return images_; }
    std::string place() const {
        return settings_.source + ", after " + std::to_string(images_) +
               (images_ == 1 ? " image" : " images");
    }

  private:
    CObservation::Ptr picture() {
        std::vector<mrpt::serialization::CSerializable::Ptr> out;
        camera_.getNextFrame(out);  // the form that returns one observation crashes at the end of a video
        for (const auto& object : out) {
            auto observation = std::dynamic_pointer_cast<CObservation>(object);
            if (observation && has_picture(*observation)) return observation;
        }
        if (out.empty() || !out.front()) {
            run_dry();
        } else {
            fail(settings_.source + ": gives " + out.front()->GetRuntimeClass()->className +
                 ", which holds no single picture");
        }
        return nullptr;
    }

    mrpt::config::CConfigFileMemory section() const {
        std::string text = "[camera]\nprocess_rate = 1\n";
        for (const auto& [key, value] : settings_.camera_keys)
            text.append(key).append(" = ").append(value) += '\n';
        return mrpt::config::CConfigFileMemory(text);
    }

    ProducerSettings settings_;
    CCameraSensor camera_;
    std::uint64_t images_ = 0;
};

/// Images that were taken at a constant rate; MRPT would stamp them with the time of decoding.
class TimedFeed : public CameraFeed {
  public:
    TimedFeed(const ProducerSettings& settings, double rate_hz) : CameraFeed(settings), rate_hz_(rate_hz) {}

  protected:
    std::optional<double> timestamp_s() const override {
        return settings().start_time_s + static_cast<double>(images()) / rate_hz_;
    }

  private:
    double rate_hz_;
};

class VideoFeed : public TimedFeed {
  public:
    VideoFeed(const ProducerSettings& settings, double rate_hz, double frames)
        : TimedFeed(settings, rate_hz), frames_(frames) {}

  protected:
    void run_dry() override {
        ended_ = true;
        const double missing = frames_ - static_cast<double>(images());
        const double estimate_off = std::max(1.0, 0.02 * frames_);  // some formats only have an estimate
        if (missing <= estimate_off) return;
        fail(place() + ": the video is cut short or damaged, it should hold " +
             std::to_string(std::llround(frames_)));
    }
    bool at_end() override { return ended_; }

  private:
    double frames_;
    bool ended_ = false;
};

class FolderFeed : public TimedFeed {
  public:
    FolderFeed(const ProducerSettings& settings, double rate_hz, NumberedFiles files, int first, int last)
        : TimedFeed(settings, rate_hz), files_(std::move(files)), at_(first), last_(last) {}

  protected:
    bool at_end() override {
        if (at_ > last_) return true;
        const int index = at_++;
        if (files_.exists(index)) return false;
        constexpr int look_ahead = 1000;
        for (int later = at_; later <= last_ && later - index < look_ahead; ++later) {
            if (!files_.exists(later)) continue;
            fail(files_.file(index).string() + " is missing, but there is " + files_.file(later).string());
            break;
        }
        return true;
    }

  private:
    NumberedFiles files_;
    int at_, last_;
};

std::unique_ptr<FieldFeed> opened(std::unique_ptr<CameraFeed> feed) {
    feed->open();
    return feed;
}

std::unique_ptr<FieldFeed> open_video(const ProducerSettings& settings, const std::string& file) {
    if (!std::filesystem::exists(file)) throw InputError(file + ": no such file");
    if (!std::filesystem::is_regular_file(file)) throw InputError(file + ": is not a file");
    cv::VideoCapture video;
    if (!video.open(file, cv::CAP_FFMPEG)) throw InputError(file + ": cannot be read as a video");
    const double rate_hz = settings.rate_hz.value_or(video.get(cv::CAP_PROP_FPS));
    if (!(rate_hz > 0) || !std::isfinite(rate_hz)) {
        throw InputError(file + ": does not tell its frame rate; set rate_hz");
    }
    return opened(std::make_unique<VideoFeed>(settings, rate_hz, video.get(cv::CAP_PROP_FRAME_COUNT)));
}

int index_of(const ProducerSettings& settings, const char* key, int otherwise) {
    const std::string text = key_of(settings, key, "");
    if (text.empty()) return otherwise;
    try {
        return std::stoi(text);
    } catch (const std::exception&) {
        throw ConfigError(std::string(key) + " = " + text + " is not a whole number");
    }
}

std::unique_ptr<FieldFeed> open_folder(ProducerSettings settings) {
    if (!settings.rate_hz) {
        throw ConfigError(
            "rate_hz is missing: the images of a folder do not tell how many there were a second");
    }
    if (!std::filesystem::is_directory(settings.source))
        throw InputError(settings.source + ": no such folder");
    const std::string format = key_of(settings, "left_format", "imL_%05d.jpg");
    NumberedFiles files(settings.source, format);
    const int first = index_of(settings, "start_index", 0);
    const int last = index_of(settings, "end_index", std::numeric_limits<int>::max() - 1);
    if (!files.exists(first)) {
        throw InputError(settings.source + ": holds no image " + files.file(first).filename().string() +
                         " (left_format, start_index)");
    }
    settings.camera_keys["left_format"] = format;
    settings.camera_keys["end_index"] = std::to_string(last);  // MRPT's default is 100
    settings.camera_keys.erase("right_format");                // the left camera is the one that is used
    return opened(std::make_unique<FolderFeed>(settings, *settings.rate_hz, std::move(files), first, last));
}

}  // namespace

std::unique_ptr<FieldFeed> open_camera(const ProducerSettings& settings) {
    if (settings.grabber_type == "image_dir") return open_folder(settings);
    const std::string scheme = "file://";
    const bool file_url = settings.source.rfind(scheme, 0) == 0;
    const bool url = settings.source.find("://") != std::string::npos;
    if (settings.grabber_type == "ffmpeg" && (file_url || !url)) {
        return open_video(settings, file_url ? settings.source.substr(scheme.size()) : settings.source);
    }
    return opened(std::make_unique<CameraFeed>(settings));
}

}  // namespace flownav::producer
