#pragma once
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/hwdrivers/CCameraSensor.h>

#include <optional>
#include <string>

#include "field_feed.h"

namespace flownav::io {

/// Source opened by CCameraSensor. Cameras and streams have no regular end.
class CameraFeed : public FieldFeed {
  public:
    explicit CameraFeed(ProducerSettings settings);

    /// Opens the source. Throws InputError.
    void open();

    mrpt::obs::CObservation::Ptr next() override;

  protected:
    /// True at the end; an override may call fail() first, to avoid MRPT's own behaviour at a missing image.
    virtual bool at_end() { return false; }

    /// Time of the next image in seconds since the epoch; empty: the grabber's own.
    virtual std::optional<double> timestamp_s() const { return std::nullopt; }

    /// Called when MRPT returns no more images.
    virtual void run_dry();

    const ProducerSettings& settings() const { return settings_; }
    std::uint64_t images() const { return images_; }

    /// The source and the number of images read, for messages.
    std::string place() const;

  private:
    mrpt::obs::CObservation::Ptr picture();
    mrpt::config::CConfigFileMemory section() const;

    ProducerSettings settings_;
    mrpt::hwdrivers::CCameraSensor camera_;
    std::uint64_t images_ = 0;
};

/// Opens a video file. Throws InputError.
std::unique_ptr<CameraFeed> make_video_feed(const ProducerSettings& settings, const std::string& file);

/// Opens a folder of numbered images. Throws InputError, and ConfigError about the keys that describe the
/// folder.
std::unique_ptr<CameraFeed> make_folder_feed(ProducerSettings settings);

}  // namespace flownav::io
