#include "flownav/obstacles/contact_scanner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

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

/// As a lens shows it, which blurs a little.
LevelImage blurred(const LevelImage& sharp) {
    LevelImage image = sharp;
    for (int v = 0; v < image.height; ++v)
        for (int u = 1; u + 1 < image.width; ++u)
            image.row(v)[u] = (sharp.row(v)[u - 1] + 2 * sharp.row(v)[u] + sharp.row(v)[u + 1]) / 4;
    return image;
}

/// The image of the full resolution whose halves are the level image; with a little fixed noise.
std::vector<std::uint8_t> doubled(const LevelImage& image, int number) {
    std::vector<std::uint8_t> out(640 * 480);
    std::mt19937 random(static_cast<unsigned>(number) + 1U);
    for (int v = 0; v < 480; ++v) {
        for (int u = 0; u < 640; ++u) {
            const int noise = static_cast<int>(random() % 5U) - 2;
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
        const std::vector<std::uint8_t> pixels = doubled(blurred(draw(world, view)), i);
        const ImageView image{pixels.data(), 640, 480, 640};
        scan_cycle(memory, {image, mapper, view.T_world_camera, 0.0, 0.01, way_known}, {}, scan);
    }
    return scan;
}

/// Floor with the contrast of a carpet.
LevelWorld carpet() {
    LevelWorld world;
    world.contrast = 6.0;
    return world;
}

/// Ranges of the contacts between two tangents.
std::vector<double> contacts_between(const ContactScan& scan, double from, double to) {
    std::vector<double> ranges_m;
    for (int i = 0; i < static_cast<int>(scan.strips.size()); ++i) {
        const ContactStrip& strip = scan.strips[static_cast<std::size_t>(i)];
        const double right = middle_tangent(scan, i);
        if (right < from || right > to || strip.kind != BeamKind::Obstacle) continue;
        EXPECT_EQ(strip.cause, BeamCause::Votes);
        EXPECT_LE(strip.near_m, strip.contact_m);
        EXPECT_GE(strip.far_m, strip.contact_m);
        ranges_m.push_back(strip.contact_m);
    }
    return ranges_m;
}

/// Expects contacts on a screen whose middle is at the tangent `right`, and none at the mirrored place.
void expect_contacts_at(const ContactScan& scan, double right, double forward_m) {
    const std::vector<double> ranges_m = contacts_between(scan, right - 0.08, right + 0.08);
    ASSERT_FALSE(ranges_m.empty());
    for (const double range_m : ranges_m) EXPECT_NEAR(range_m, forward_m, 0.2 * forward_m);
    EXPECT_TRUE(contacts_between(scan, -right - 0.08, -right + 0.08).empty());
}

constexpr double ahead_m = 2.5 - 0.64;  // of a screen at 2.5 m, after five cycles

TEST(ContactScan, AScreenOfOneColourOnTheRightIsAContactOnTheRight) {
    LevelWorld world = carpet();
    world.screens.push_back({2.5, -0.75, 0.2, 0.5, 15.0});
    const ContactScan scan = drive(world, 5);
    ASSERT_EQ(scan.gate, ContactGate::Open);
    expect_contacts_at(scan, 0.75 / ahead_m, ahead_m);
}

TEST(ContactScan, AScreenOfOneColourOnTheLeftIsAContactOnTheLeft) {
    LevelWorld world = carpet();
    world.screens.push_back({2.5, 0.75, 0.2, 0.5, 15.0});
    expect_contacts_at(drive(world, 5), -0.75 / ahead_m, ahead_m);
}

/// A screen as bright as the floor that stands out from the sky, `side` m to the right.
LevelWorld hidden_below_the_horizon(double x_m, double right_m) {
    LevelWorld world = carpet();
    world.screens.push_back({x_m, -right_m, 0.3, 1.5, 128.0});
    return world;
}

TEST(ContactScan, AThingAsBrightAsTheFloorShowsByItsEdgesAboveTheHorizon) {
    for (const double side : {1.0, -1.0}) {
        const ContactScan scan = drive(hidden_below_the_horizon(2.5, side * 0.75), 5);
        expect_contacts_at(scan, side * 0.75 / ahead_m, ahead_m);
    }
}

TEST(ContactScan, StraightAheadSuchAThingShowsAfterLongerWays) {
    const ContactScan scan = drive(hidden_below_the_horizon(3.6, 0.0), 10);
    EXPECT_FALSE(contacts_between(scan, -0.1, 0.1).empty());
}

TEST(ContactScan, EdgesFarAwayAreNoContacts) {
    const ContactScan scan = drive(hidden_below_the_horizon(9.0, 2.0), 5);
    EXPECT_TRUE(contacts_between(scan, -1.0, 1.0).empty());
}

TEST(ContactScan, TexturedFloorIsFreeAndHasNoContacts) {
    const ContactScan scan = drive({}, 5);
    int free = 0;
    for (int i = 0; i < static_cast<int>(scan.strips.size()); ++i) {
        const ContactStrip& strip = scan.strips[static_cast<std::size_t>(i)];
        EXPECT_NE(strip.kind, BeamKind::Obstacle) << middle_tangent(scan, i);
        free += std::abs(middle_tangent(scan, i)) < 0.7 && strip.free_m > 1.5;
    }
    EXPECT_GE(free, 12) << "its waves have plain places";
}

TEST(ContactScan, FloorWithoutTextureIsUnknown) {
    LevelWorld world;
    world.contrast = 0.0;
    for (const ContactStrip& strip : drive(world, 5).strips) EXPECT_EQ(strip.kind, BeamKind::Unknown);
}

TEST(ContactScan, WeakTextureThatNoPixelShowsIsFloorWhenManyTellOfIt) {
    LevelWorld world;
    world.contrast = 0.0;
    world.grain = 3.0;
    int free = 0;
    for (const ContactStrip& strip : drive(world, 6).strips) {
        EXPECT_NE(strip.kind, BeamKind::Obstacle);
        free += strip.free_m > 0.8;
    }
    EXPECT_GE(free, 8);
}

TEST(ContactScan, ItsPartsGiveTheSameScanInOneGoAndSpreadOverFields) {
    LevelWorld world = carpet();
    world.screens.push_back({2.5, -0.75, 0.2, 0.5, 15.0});
    const ContactScan at_once = drive(world, 5);
    const RayMapper mapper(camera());
    ContactMemory memory;
    restart(memory, mapper);
    ContactScan scan;
    for (int i = 0; i < 5; ++i) {
        LevelView view;
        view.T_world_camera.x_m = i * 0.16;
        std::vector<std::uint8_t> pixels = doubled(blurred(draw(world, view)), i);
        ASSERT_TRUE(begin_scan(
            memory, {{pixels.data(), 640, 480, 640}, mapper, view.T_world_camera, 0.0, 0.01, true}, {}));
        std::fill(pixels.begin(), pixels.end(),
                  std::uint8_t{0});  // the image is needed for the first part only
        int parts = 1;
        while (!continue_scan(memory, {}, scan)) ++parts;
        EXPECT_EQ(parts, i == 0 ? 1 : 5);
        EXPECT_FALSE(is_scanning(memory));
        EXPECT_FALSE(continue_scan(memory, {}, scan)) << "there is no more";
    }
    ASSERT_EQ(scan.strips.size(), at_once.strips.size());
    for (std::size_t i = 0; i < scan.strips.size(); ++i) {
        EXPECT_EQ(scan.strips[i].kind, at_once.strips[i].kind);
        EXPECT_EQ(scan.strips[i].contact_m, at_once.strips[i].contact_m);
        EXPECT_EQ(scan.strips[i].free_m, at_once.strips[i].free_m);
    }
}

TEST(ContactScan, FloorBehindAContactIsNotFree) {
    LevelWorld world = carpet();
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
    LevelWorld world = carpet();
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
    LevelWorld world = carpet();
    world.screens.push_back({2.5, -0.75, 0.2, 0.5, 15.0});
    const ContactScan scan = drive(world, 17, 0.04);
    ASSERT_EQ(scan.gate, ContactGate::Open);
    expect_contacts_at(scan, 0.75 / ahead_m, ahead_m);
}

TEST(ContactScan, IsTheSameEveryTime) {
    LevelWorld world = carpet();
    world.screens.push_back({2.5, -0.75, 0.2, 0.5, 15.0});
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
