#pragma once
#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "flownav/io/producer_settings.h"

namespace flownav::io {

/// Where observations come from, one after the other.
class FieldFeed {
  public:
    FieldFeed() = default;
    virtual ~FieldFeed() = default;
    FieldFeed(const FieldFeed&) = delete;
    FieldFeed& operator=(const FieldFeed&) = delete;

    /// The next observation, waiting for it if need be; null at the end. Never throws on bad input.
    virtual mrpt::obs::CObservation::Ptr next() = 0;

    /// Folder that relative names of externally stored images refer to.
    virtual std::filesystem::path images_directory() const { return {}; }

    /// Whole objects of a rawlog that were read.
    virtual std::uint64_t objects() const { return 0; }

    /// Why there is no more; empty: a file came to its regular end.
    const std::string& error() const { return error_; }

  protected:
    void fail(const std::string& error) { error_ = error; }

  private:
    std::string error_;
};

/// Both throw InputError when the source cannot be opened.
std::unique_ptr<FieldFeed> open_rawlog(const ProducerSettings& settings);
std::unique_ptr<FieldFeed> open_camera(const ProducerSettings& settings);

}  // namespace flownav::io
