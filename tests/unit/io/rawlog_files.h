#pragma once
#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CSerializable.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// Small rawlogs for the tests of reading.
namespace flownav::testing {

/// Creates an empty folder for the running test.
std::filesystem::path test_folder();

/// Serializes objects one after the other, as MRPT writes them.
std::string serialized(const std::vector<mrpt::serialization::CSerializable::ConstPtr>& objects);

std::string gz(const std::string& bytes);
void write_bytes(const std::filesystem::path& file, const std::string& bytes);

/// A calibrated 64 x 48 grey image with a pattern that compresses badly; camera 0.5 m high, 10 deg down.
mrpt::obs::CObservationImage::Ptr image_at(double timestamp_s, unsigned seed = 1);
mrpt::obs::CObservationOdometry::Ptr odometry_at(double timestamp_s, double x_m);
mrpt::obs::CObservationRobotPose::Ptr truth_at(double timestamp_s, double x_m);

/// Eight images with poses in between, as a list of observations.
std::vector<mrpt::serialization::CSerializable::ConstPtr> small_recording();

}  // namespace flownav::testing
