#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/videoio.hpp>
#include <utility>

#include "camera_feed.h"
#include "flownav/io/rawlog_reader.h"
#include "numbered_files.h"

namespace flownav::io {
namespace {

/// Images taken at a constant rate. Replaces MRPT's time stamps, which are the times of decoding.
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
        const double tolerance = std::max(1.0, 0.02 * frames_);  // some formats hold only an estimate
        if (missing <= tolerance) return;
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

std::unique_ptr<CameraFeed> make_video_feed(const ProducerSettings& settings, const std::string& file) {
    if (!std::filesystem::exists(file)) throw InputError(file + ": no such file");
    if (!std::filesystem::is_regular_file(file)) throw InputError(file + ": is not a file");
    cv::VideoCapture video;
    if (!video.open(file, cv::CAP_FFMPEG)) throw InputError(file + ": cannot be read as a video");
    const double rate_hz = settings.rate_hz.value_or(video.get(cv::CAP_PROP_FPS));
    if (!(rate_hz > 0) || !std::isfinite(rate_hz)) {
        throw InputError(file + ": does not tell its frame rate; set rate_hz");
    }
    return std::make_unique<VideoFeed>(settings, rate_hz, video.get(cv::CAP_PROP_FRAME_COUNT));
}

std::unique_ptr<CameraFeed> make_folder_feed(ProducerSettings settings) {
    if (!settings.rate_hz) {
        throw config::ConfigError(
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
    settings.camera_keys.erase("right_format");                // only the left camera is used
    return std::make_unique<FolderFeed>(settings, *settings.rate_hz, std::move(files), first, last);
}

}  // namespace flownav::io
