#pragma once
#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "flownav/io/producer_settings.h"

namespace flownav::io {

/// Source of observations.
class FieldFeed {
  public:
    FieldFeed() = default;
    virtual ~FieldFeed() = default;
    FieldFeed(const FieldFeed&) = delete;
    FieldFeed& operator=(const FieldFeed&) = delete;

    /// Waits for the next observation; null at the end. Never throws on bad input.
    virtual mrpt::obs::CObservation::Ptr next() = 0;

    /// Folder that relative names of externally stored images refer to.
    virtual std::filesystem::path images_directory() const { return {}; }

    /// Number of whole rawlog objects read; 0 for other sources.
    virtual std::uint64_t objects() const { return 0; }

    /// What was recognised or mended so far, one sentence each.
    virtual std::vector<std::string> notes() const { return {}; }

    /// Reason of the end; empty at the regular end of a file.
    const std::string& error() const { return error_; }

  protected:
    void fail(const std::string& error) { error_ = error; }

  private:
    std::string error_;
};

/// Open a source. Throw InputError when it cannot be opened.
std::unique_ptr<FieldFeed> open_rawlog(const ProducerSettings& settings);
std::unique_ptr<FieldFeed> open_camera(const ProducerSettings& settings);

}  // namespace flownav::io
