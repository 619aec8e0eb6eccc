#include "compare_rawlogs.h"

#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "flownav/io/rawlog_reader.h"

namespace flownav::testing {
namespace {

using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CObservationPointCloud;
using mrpt::obs::CObservationRobotPose;

void widen(double& most, double a, double b) {
    most = std::max(most, std::abs(a - b));
}

void compare(const CObservationOdometry& a, const CObservationOdometry& b, Differences& most) {
    widen(most.omega_radps, a.velocityLocal.omega, b.velocityLocal.omega);
    widen(most.v_mps, a.velocityLocal.vx, b.velocityLocal.vx);
    widen(most.position_m, a.odometry.x(), b.odometry.x());
    widen(most.position_m, a.odometry.y(), b.odometry.y());
    widen(most.heading_rad, a.odometry.phi(), b.odometry.phi());
    if (a.hasVelocities != b.hasVelocities) ++most.validity;
}

void compare(const CObservation2DRangeScan& a, const CObservation2DRangeScan& b, Differences& most) {
    if (a.getScanSize() != b.getScanSize()) ++most.beams;
    for (std::size_t i = 0; i < std::min(a.getScanSize(), b.getScanSize()); ++i) {
        const bool same_kind = a.getScanRangeValidity(i) == b.getScanRangeValidity(i);
        if (!same_kind || std::abs(a.getScanRange(i) - b.getScanRange(i)) > 0.01) {
            ++most.other_beams;
        } else {
            widen(most.range_m, a.getScanRange(i), b.getScanRange(i));
        }
    }
}

void compare(const CObservationPointCloud& a, const CObservationPointCloud& b, Differences& most) {
    if (a.pointcloud->size() != b.pointcloud->size()) ++most.points;
    for (std::size_t i = 0; i < std::min(a.pointcloud->size(), b.pointcloud->size()); ++i) {
        mrpt::math::TPoint3Df left, right;
        a.pointcloud->getPoint(i, left.x, left.y, left.z);
        b.pointcloud->getPoint(i, right.x, right.y, right.z);
        widen(most.point_m, (left - right).norm(), 0.0);
    }
}

void compare(const CObservationRobotPose& a, const CObservationRobotPose& b, Differences& most) {
    widen(most.position_m, a.pose.mean.x(), b.pose.mean.x());
    widen(most.position_m, a.pose.mean.y(), b.pose.mean.y());
    widen(most.heading_rad, a.pose.mean.yaw(), b.pose.mean.yaw());
}

/// True when both objects are of this class.
template <class Class>
bool compare_as(const CObservation& a, const CObservation& b, Differences& most) {
    const auto* const left = dynamic_cast<const Class*>(&a);
    const auto* const right = dynamic_cast<const Class*>(&b);
    if (left == nullptr || right == nullptr) return false;
    compare(*left, *right, most);
    return true;
}

}  // namespace

ByLabel observations_of(const std::filesystem::path& rawlog) {
    ByLabel found;
    io::RawlogReader reader(rawlog);
    while (auto observation = reader.next()) found[observation->sensorLabel].push_back(observation);
    EXPECT_EQ(reader.end().kind, io::ReadEnd::Kind::Clean) << reader.end().message;
    return found;
}

std::map<std::string, std::size_t> counts(const ByLabel& observations) {
    std::map<std::string, std::size_t> counts;
    for (const auto& [label, list] : observations) counts[label] = list.size();
    return counts;
}

Differences compared(const ByLabel& found, const ByLabel& expected) {
    Differences most;
    for (const auto& [label, list] : expected) {
        const auto& other = found.at(label);
        EXPECT_EQ(other.size(), list.size()) << label;
        for (std::size_t i = 0; i < std::min(list.size(), other.size()); ++i) {
            const CObservation &a = *other[i], &b = *list[i];
            widen(most.time_s, mrpt::Clock::toDouble(a.timestamp), mrpt::Clock::toDouble(b.timestamp));
            EXPECT_TRUE(compare_as<CObservationOdometry>(a, b, most) ||
                        compare_as<CObservation2DRangeScan>(a, b, most) ||
                        compare_as<CObservationPointCloud>(a, b, most) ||
                        compare_as<CObservationRobotPose>(a, b, most))
                << label << " is of no class that can be compared";
        }
    }
    return most;
}

std::ostream& operator<<(std::ostream& out, const Differences& d) {
    return out << "time " << d.time_s << " s, omega " << d.omega_radps << " rad/s, v " << d.v_mps
               << " m/s, position " << d.position_m << " m, heading " << d.heading_rad << " rad, ranges "
               << d.range_m << " m, points " << d.point_m << " m; of different validity " << d.validity
               << ", size " << d.beams << ", number " << d.points << "; beams that end elsewhere "
               << d.other_beams;
}

}  // namespace flownav::testing
