#pragma once

#include <array>
#include <optional>

#include "flownav/core/sensor_report.h"
#include "flownav/nav/guard_params.h"
#include "flownav/nav/guard_reason.h"

namespace flownav::nav {

/// Detects a blind, stale or lost flow sensor from its reports. Standing still is not blind: a standing
/// camera has as many confident vectors as a moving one, all of them zero.
class SensorWatch {
  public:
    explicit SensorWatch(const SensorWatchParams& params) : params_(params) {}

    void sensed(const SensorReport& report);

    /// Fault at `time_s`. To be called at least once per field, with rising times.
    Fault fault(double time_s);

    /// True when only some sectors of the image are blind.
    bool is_partly_blind() const { return partly_blind_; }

  private:
    Fault stale(double time_s) const;
    Fault unseeing() const;
    Fault blind_sector() const;
    void note_sectors(const SensorReport& report);

    SensorWatchParams params_;
    std::optional<SensorReport> newest_;
    bool arrived_ = false;  ///< a field arrived since the last fault()
    double last_arrival_s_ = 0.0;
    double last_ok_s_ = 0.0;    ///< time stamp of the last field with enough vectors and omega
    double last_seen_s_ = 0.0;  ///< time stamp of the last field with enough vectors
    std::array<std::optional<double>, SensorReport::sectors> blind_since_s_;
    bool partly_blind_ = false;
};

}  // namespace flownav::nav
