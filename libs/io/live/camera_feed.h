#pragma once
#include <mrpt/hwdrivers/CCameraSensor.h>

#include <string>

#include "field_feed.h"

namespace flownav::io {

/// Camera or stream opened by CCameraSensor, with the grabber's times. It has no regular end.
class CameraFeed : public FieldFeed {
  public:
    explicit CameraFeed(ProducerSettings settings);

    /// Opens the source. Throws InputError.
    void open();

    mrpt::obs::CObservation::Ptr next() override;

  private:
    mrpt::obs::CObservation::Ptr picture();

    /// The source and the number of images read, for messages.
    std::string place() const;

    ProducerSettings settings_;
    mrpt::hwdrivers::CCameraSensor camera_;
    std::uint64_t images_ = 0;
};

}  // namespace flownav::io
