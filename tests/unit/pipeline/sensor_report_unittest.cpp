#include "flownav/pipeline/sensor_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "flownav/math/units.h"
#include "flownav/testing/contact_scans.h"

namespace flownav::pipeline {
namespace {

CameraModel camera() {
    CameraModel c;
    c.width_px = 640;
    c.height_px = 480;
    c.fx_px = c.fy_px = 320.0;
    c.cx_px = 319.5;
    c.cy_px = 239.5;
    c.mount.pitch_rad = 18.0 * degree_rad;
    return c;
}

TEST(SensorReportOfStep, ScansSeeEdgesWhenAStripShowsOneAndTheFloorIsBelieved) {
    Step step;
    EXPECT_FALSE(sensor_report(step, camera()).scans);
    step.contacts = testing::open_scan();
    EXPECT_TRUE(sensor_report(step, camera()).scans);
    EXPECT_TRUE(sensor_report(step, camera()).sees_edges);
    for (ContactStrip& strip : step.contacts.strips) strip.seen = false;
    EXPECT_FALSE(sensor_report(step, camera()).sees_edges);
    step.contacts = testing::open_scan();
    step.contacts.gate = ContactGate::PoorFloor;
    EXPECT_FALSE(sensor_report(step, camera()).sees_edges);
}

TEST(UnlitSectors, BlackAndSaturatedSectorsAreUnlitFromTheLeft) {
    std::vector<std::uint8_t> grey(640 * 480, 128);
    for (int v = 0; v < 480; ++v) {
        std::fill_n(grey.begin() + v * 640, 160, std::uint8_t{12});
        std::fill_n(grey.begin() + v * 640 + 320, 160, std::uint8_t{255});
    }
    const std::array<bool, 4> expected = {true, false, true, false};
    EXPECT_EQ(unlit_sectors({grey.data(), 640, 480, 640}), expected);
    EXPECT_EQ(unlit_sectors({grey.data(), 0, 0, 0}), (std::array<bool, 4>{}));
}

}  // namespace
}  // namespace flownav::pipeline
