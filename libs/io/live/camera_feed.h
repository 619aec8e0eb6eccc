#pragma once
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/hwdrivers/CCameraSensor.h>

#include <optional>
#include <string>

#include "field_feed.h"

namespace flownav::io {

/// Whatever CCameraSensor can open. Cameras and streams never end regularly.
class CameraFeed : public FieldFeed {
  public:
    explicit CameraFeed(ProducerSettings settings);

    /// Throws InputError.
    void open();

    mrpt::obs::CObservation::Ptr next() override;

  protected:
    /// True at a regular end; may also fail() instead of running into what MRPT would do.
    virtual bool at_end() { return false; }

    /// Of the image that comes; nothing: the grabber's own.
    virtual std::optional<double> timestamp_s() const { return std::nullopt; }

    /// MRPT gives nothing more.
    virtual void run_dry();

    const ProducerSettings& settings() const { return settings_; }
    std::uint64_t images() const { return images_; }

    /// The source and how far it came, for messages.
    std::string place() const;

  private:
    mrpt::obs::CObservation::Ptr picture();
    mrpt::config::CConfigFileMemory section() const;

    ProducerSettings settings_;
    mrpt::hwdrivers::CCameraSensor camera_;
    std::uint64_t images_ = 0;
};

/// A video file. Throws InputError.
std::unique_ptr<CameraFeed> make_video_feed(const ProducerSettings& settings, const std::string& file);

/// A folder of numbered images. Throws InputError, and ConfigError about the keys that describe the folder.
std::unique_ptr<CameraFeed> make_folder_feed(ProducerSettings settings);

}  // namespace flownav::io
