#include "file_feeds.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationImage.h>

#include <limits>
#include <opencv2/core/mat.hpp>
#include <utility>
#include <vector>

#include "files/video_images.h"
#include "flownav/io/rawlog_reader.h"
#include "flownav/math/units.h"
#include "import/grey_pictures.h"
#include "numbered_files.h"

namespace flownav::io {
namespace {

using mrpt::obs::CObservation;
using mrpt::obs::CObservationImage;

/// Pose of the camera by the keys pose_x ... pose_roll of the section, in metres and degrees.
mrpt::poses::CPose3D camera_pose_of(const ProducerSettings& settings) {
    const auto ini = camera_section(settings);
    const auto value = [&](const char* key) { return ini.read_double("camera", key, 0.0); };
    return {value("pose_x"),
            value("pose_y"),
            value("pose_z"),
            degree_rad * value("pose_yaw"),
            degree_rad * value("pose_pitch"),
            degree_rad * value("pose_roll")};
}

/// Images of files, with the camera's label and pose and times after the start time.
class FileFeed : public FieldFeed {
  public:
    explicit FileFeed(const ProducerSettings& settings)
        : settings_(settings), camera_pose_(camera_pose_of(settings)) {}

  protected:
    CObservation::Ptr observation(const Field& field) {
        const cv::Mat pixels(field.image.height_px, field.image.width_px, CV_8UC1,
                             const_cast<std::uint8_t*>(field.image.data),
                             static_cast<std::size_t>(field.image.stride_bytes));
        auto image = CObservationImage::Create();
        image->image = mrpt::img::CImage(pixels, mrpt::img::DEEP_COPY);
        image->cameraPose = camera_pose_;
        image->sensorLabel = settings_.config.camera.camera_label;
        image->timestamp = mrpt::Clock::fromDouble(settings_.start_time_s + field.timestamp_s);
        ++images_;
        return image;
    }

    std::string place() const { return place_after(settings_.source, images_); }
    std::uint64_t images() const { return images_; }

  private:
    ProducerSettings settings_;
    mrpt::poses::CPose3D camera_pose_;
    std::uint64_t images_ = 0;
};

class VideoFeed : public FileFeed {
  public:
    VideoFeed(const ProducerSettings& settings, const std::string& file)
        : FileFeed(settings),
          video_(file, settings.rate_hz, "rate_hz"),
          interlaced_(settings.config.camera.interlaced) {}

    CObservation::Ptr next() override {
        if (auto field = video_.next()) return observation(*field);
        std::string text;
        for (const std::string& problem : video_.problems()) text += (text.empty() ? "" : "; ") + problem;
        if (!text.empty()) fail(place() + ": " + text);
        return nullptr;
    }

    std::vector<std::string> notes() const override {
        std::vector<std::string> all = video_.notes();
        const std::string advice = video_.advice(interlaced_);
        if (!advice.empty()) all.push_back(advice);
        return all;
    }

  private:
    VideoImages video_;
    config::Interlaced interlaced_;
};

class FolderFeed : public FileFeed {
  public:
    FolderFeed(const ProducerSettings& settings, double rate_hz, NumberedFiles files, int first, int last)
        : FileFeed(settings),
          rate_hz_(rate_hz),
          files_(std::move(files)),
          pictures_(first_files(files_, first, last)),
          at_(first),
          last_(last) {}

    CObservation::Ptr next() override {
        if (at_end()) return nullptr;
        auto field = pictures_.load(files_.file(at_++));
        if (!field) {
            fail(place() + ": " + pictures_.why());
            return nullptr;
        }
        field->timestamp_s = static_cast<double>(images()) / rate_hz_;
        return observation(*field);
    }

    std::vector<std::string> notes() const override {
        std::vector<std::string> all;
        for (const std::string& note : {pictures_.note(), pictures_.brighter()})
            if (!note.empty()) all.push_back(note);
        return all;
    }

  private:
    static std::vector<std::filesystem::path> first_files(const NumberedFiles& files, int first, int last) {
        constexpr int looked_at = 64;
        std::vector<std::filesystem::path> list;
        for (int i = first; i <= last && i - first < looked_at && files.exists(i); ++i)
            list.push_back(files.file(i));
        return list;
    }

    /// True at the end; tells of a missing image when there are later ones.
    bool at_end() {
        if (!error().empty() || at_ > last_) return true;
        if (files_.exists(at_)) return false;
        constexpr int look_ahead = 1000;
        for (int later = at_ + 1; later <= last_ && later - at_ < look_ahead; ++later) {
            if (!files_.exists(later)) continue;
            fail(files_.file(at_).string() + " is missing, but there is " + files_.file(later).string());
            break;
        }
        return true;
    }

    double rate_hz_;
    NumberedFiles files_;
    GreyPictures pictures_;
    int at_, last_;
};

std::string key_of(const ProducerSettings& settings, const std::string& key, const std::string& otherwise) {
    const auto found = settings.camera_keys.find(key);
    return found == settings.camera_keys.end() ? otherwise : found->second;
}

int index_of(const ProducerSettings& settings, const char* key, int otherwise) {
    const std::string text = key_of(settings, key, "");
    if (text.empty()) return otherwise;
    try {
        return std::stoi(text);
    } catch (const std::exception&) {
        throw config::ConfigError(std::string(key) + " = " + text + " is not a whole number");
    }
}

}  // namespace

std::unique_ptr<FieldFeed> make_video_feed(const ProducerSettings& settings, const std::string& file) {
    return std::make_unique<VideoFeed>(settings, file);
}

std::unique_ptr<FieldFeed> make_folder_feed(const ProducerSettings& settings) {
    if (!settings.rate_hz) {
        throw config::ConfigError(
            "rate_hz is missing: the images of a folder do not tell how many there were a second");
    }
    if (!std::filesystem::is_directory(settings.source))
        throw InputError(settings.source + ": no such folder");
    NumberedFiles files(settings.source, key_of(settings, "left_format", "imL_%05d.jpg"));
    const int first = index_of(settings, "start_index", 0);
    const int last = index_of(settings, "end_index", std::numeric_limits<int>::max() - 1);
    if (!files.exists(first)) {
        throw InputError(settings.source + ": holds no image " + files.file(first).filename().string() +
                         " (left_format, start_index)");
    }
    return std::make_unique<FolderFeed>(settings, *settings.rate_hz, std::move(files), first, last);
}

}  // namespace flownav::io
