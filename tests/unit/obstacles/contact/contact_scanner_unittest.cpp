#include "flownav/obstacles/contact_scanner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "level_world.h"

namespace flownav::obstacles {
namespace {

using testing::LevelView;
using testing::LevelWorld;
using testing::Screen;

CameraModel camera() {
    CameraModel c;
    c.width_px = 640;
    c.height_px = 480;
    c.fx_px = c.fy_px = 320.0;
    c.cx_px = 319.5;
    c.cy_px = 239.5;
    c.mount.height_m = 0.6;
    c.mount.pitch_rad = 18.0 * degree_rad;
    return c;
}

/// The image of the full resolution whose halves are the level image; with a little fixed noise.
std::vector<std::uint8_t> doubled(const LevelImage& image, int number) {
    std::vector<std::uint8_t> out(640 * 480);
    std::uint32_t random = 12345U + 77U * static_cast<std::uint32_t>(number);
    for (int v = 0; v < 480; ++v) {
        for (int u = 0; u < 640; ++u) {
            random = random * 1664525U + 1013904223U;
            const int noise = static_cast<int>(random >> 24U) % 5 - 2;
            const int grey = static_cast<int>(image.row(v / 2)[u / 2]) + noise;
            out[static_cast<std::size_t>(v * 640 + u)] = static_cast<std::uint8_t>(std::clamp(grey, 0, 255));
        }
    }
    return out;
}

/// Drives straight ahead along x in cycles of `travel_m` and scans every cycle; returns the last scan.
ContactScan drive(const LevelWorld& world, int cycles, double travel_m = 0.16, bool way_known = true) {
    const RayMapper mapper(camera());
    ContactMemory memory;
    restart(memory, mapper);
    ContactScan scan;
    for (int i = 0; i < cycles; ++i) {
        LevelView view;
        view.T_world_camera.x_m = i * travel_m;
        const std::vector<std::uint8_t> pixels = doubled(draw(world, view), i);
        const ImageView image{pixels.data(), 640, 480, 640};
        scan_cycle(memory, {image, mapper, view.T_world_camera, 0.0, 0.01, way_known}, {}, scan);
    }
    return scan;
}

const ContactStrip& strip_at(const ContactScan& scan, double right) {
    const int i = static_cast<int>(std::floor(right / scan.step)) - scan.first;
    return scan.strips.at(static_cast<std::size_t>(i));
}

TEST(ContactScan, AScreenOfOneColourOnTheRightIsAContactOnTheRight) {
    LevelWorld world;
    world.screens.push_back({2.5, -0.75, 0.2, 0.5, 60.0});
    const ContactScan scan = drive(world, 5);  // ends at x = 0.64
    ASSERT_EQ(scan.gate, ContactGate::Open);
    const double forward_m = 2.5 - 0.64;
    const ContactStrip& right = strip_at(scan, 0.75 / forward_m);
    EXPECT_EQ(right.kind, BeamKind::Obstacle);
    EXPECT_EQ(right.cause, BeamCause::Votes);
    EXPECT_NEAR(right.contact_m, forward_m, 0.15 * forward_m);
    EXPECT_LE(right.near_m, right.contact_m);
    EXPECT_GE(right.far_m, right.contact_m);
    EXPECT_NE(strip_at(scan, -0.75 / forward_m).kind, BeamKind::Obstacle);
}

TEST(ContactScan, AScreenOfOneColourOnTheLeftIsAContactOnTheLeft) {
    LevelWorld world;
    world.screens.push_back({2.5, 0.75, 0.2, 0.5, 60.0});
    const ContactScan scan = drive(world, 5);
    const double forward_m = 2.5 - 0.64;
    EXPECT_EQ(strip_at(scan, -0.75 / forward_m).kind, BeamKind::Obstacle);
    EXPECT_NE(strip_at(scan, 0.75 / forward_m).kind, BeamKind::Obstacle);
}

TEST(ContactScan, TexturedFloorIsFreeAndHasNoContacts) {
    const ContactScan scan = drive({}, 5);
    int free = 0;
    for (int i = 0; i < static_cast<int>(scan.strips.size()); ++i) {
        const ContactStrip& strip = scan.strips[static_cast<std::size_t>(i)];
        EXPECT_NE(strip.kind, BeamKind::Obstacle) << middle_tangent(scan, i);
        free += std::abs(middle_tangent(scan, i)) < 0.7 && strip.free_m > 1.5;
    }
    EXPECT_GE(free, 24);
}

TEST(ContactScan, FloorWithoutTextureIsUnknown) {
    LevelWorld world;
    world.contrast = 0.0;
    for (const ContactStrip& strip : drive(world, 5).strips) EXPECT_EQ(strip.kind, BeamKind::Unknown);
}

TEST(ContactScan, FloorBehindAContactIsNotFree) {
    LevelWorld world;
    world.screens.push_back({2.2, 0.0, 3.0, 1.5, 60.0});
    const ContactScan scan = drive(world, 5);
    const double forward_m = 2.2 - 0.64;
    for (int i = 0; i < static_cast<int>(scan.strips.size()); ++i) {
        if (std::abs(middle_tangent(scan, i)) < 0.6) {
            EXPECT_LT(scan.strips[static_cast<std::size_t>(i)].free_m, 1.1 * forward_m);
        }
    }
}

TEST(ContactScan, TapeOnTheFloorIsNoContact) {
    LevelWorld world;
    // A screen two millimetres high and painted on the floor for half a metre behind it.
    for (int i = 0; i < 50; ++i) world.screens.push_back({2.0 + 0.002 * i, 0.5, 0.8, 0.0006, 220.0});
    for (const ContactStrip& strip : drive(world, 5).strips) EXPECT_NE(strip.kind, BeamKind::Obstacle);
}

TEST(ContactScan, AnUnknownWayClosesTheGate) {
    const ContactScan scan = drive({}, 5, 0.16, false);
    EXPECT_EQ(scan.gate, ContactGate::NoTravel);
    for (const ContactStrip& strip : scan.strips) EXPECT_EQ(strip.kind, BeamKind::Unknown);
}

TEST(ContactScan, ShortCyclesAreAddedUp) {
    LevelWorld world;
    world.screens.push_back({2.5, -0.75, 0.2, 0.5, 60.0});
    const ContactScan scan = drive(world, 17, 0.04);
    ASSERT_EQ(scan.gate, ContactGate::Open);
    EXPECT_EQ(strip_at(scan, 0.75 / (2.5 - 0.64)).kind, BeamKind::Obstacle);
}

TEST(ContactScan, IsTheSameEveryTime) {
    LevelWorld world;
    world.screens.push_back({2.5, -0.75, 0.2, 0.5, 60.0});
    const ContactScan one = drive(world, 5);
    const ContactScan other = drive(world, 5);
    ASSERT_EQ(one.strips.size(), other.strips.size());
    for (std::size_t i = 0; i < one.strips.size(); ++i) {
        EXPECT_EQ(one.strips[i].score, other.strips[i].score);
        EXPECT_EQ(one.strips[i].free_m, other.strips[i].free_m);
    }
}

}  // namespace
}  // namespace flownav::obstacles
