#pragma once
#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "flownav/core/field.h"
#include "flownav/io/field_source.h"
#include "flownav/io/output_file.h"
#include "flownav/pipeline/step.h"

namespace flownav::replay {

/// Writes result.rawlog: a gz list of observations of MRPT's standard classes, in the order of the calls. All
/// functions throw OutputError.
class ResultRawlog {
  public:
    /// `range_max_m`: largest range of the scans.
    ResultRawlog(const std::filesystem::path& path, double range_max_m)
        : file_(path), range_max_m_(range_max_m) {}

    /// Writes FLOW_ODOMETRY and FLOW_POSE, and at the end of a cycle FLOW_SCAN and FLOW_POINTS.
    void write(const pipeline::Step& step);

    /// Writes a copy of the robot's own odometry.
    void write_odometry(const io::PoseSample& sample);

    /// Writes the field as used: grey, one parity, with the applied calibration and camera pose.
    void write_image(const Field& field, const std::string& label);

    /// Number of observations written so far, by label.
    const std::map<std::string, std::uint64_t>& counts() const { return counts_; }
    void close() { file_.close(); }

  private:
    void write_object(const mrpt::obs::CObservation& observation);

    io::GzOutputFile file_;
    double range_max_m_;
    std::map<std::string, std::uint64_t> counts_;
};

}  // namespace flownav::replay
