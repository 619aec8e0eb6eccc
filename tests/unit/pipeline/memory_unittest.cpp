#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "drives.h"
#include "flownav/mapping/local_map.h"
#include "flownav/testing/contact_scans.h"

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t bytes) {
    ++allocations;
    void* memory = std::malloc(bytes);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(std::size_t bytes) {
    return counted(bytes);
}
void* operator new[](std::size_t bytes) {
    return counted(bytes);
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    return counted(bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
    return counted(bytes);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace flownav {
namespace {

TEST(Memory, CountingWorks) {
    const long before = allocations;
    const std::vector<int> some(100);
    EXPECT_EQ(allocations - before, 1);
}

TEST(Memory, InSteadyStateNothingIsAllocatedPerField) {
    testing::DriveOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = 13;
    const std::vector<Field> fields = render_fields(testing::drive(options));
    pipeline::State state(testing::cycles_of(3));
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const long before = allocations;
        pipeline::step(state, fields[i]);
        const long made = allocations - before;
        if (i >= 7) {
            EXPECT_EQ(made, 0) << "field " << i;
        }
    }
}

TEST(Memory, InSteadyStateReadingsOfWheelsAndGyroAllocateNothing) {
    testing::DriveOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = 13;
    const testing::Scene scene = testing::drive(options);
    const std::vector<Field> fields = render_fields(scene);
    pipeline::State state(testing::cycles_of(3));
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const long before = allocations;
        pipeline::note_wheels(state, {fields[i].timestamp_s, scene.poses[i]});
        pipeline::note_gyro(state, {fields[i].timestamp_s, 0.01});
        pipeline::step(state, fields[i]);
        const long made = allocations - before;
        if (i >= 7) {
            EXPECT_EQ(made, 0) << "field " << i;
        }
    }
}

TEST(Memory, InSteadyStateTheLocalMapAllocatesNothing) {
    mapping::LocalMap map({});
    mapping::ObstacleSet set;
    for (int i = 0; i < 40; ++i) {
        ObstaclePoint point;
        point.position_m = {1.0 + 0.05 * i, 0.1 * (i % 7) - 0.3, 0.2};
        point.sigma_m = 0.03;
        point.moving = i % 13 == 0;
        set.points.push_back(point);
        set.ground.push_back({{0.8, 0.02 * i}, {1.0 + 0.03 * i, 0.05 * i}, 0.2});
    }
    set.contacts = testing::free_scan(2.5);
    testing::block(set.contacts, -0.2, 0.0, 1.5);
    testing::block(set.contacts, 0.0, 0.2, 2.0, BeamCause::Drop);
    for (int i = 0; i < 400; ++i) {
        set.contacts.T_robot_scan.x_m = -0.01 * (i % 5);
        set.timestamp_s = 0.1 * i;  // the map's memory is full after 60 sets
        const long before = allocations;
        map.insert(set);
        map.redraw({0.01 * i, 0.0, 0.02 * i});
        const long made = allocations - before;
        if (i >= 200) {
            EXPECT_EQ(made, 0) << "set " << i;
        }
    }
}

}  // namespace
}  // namespace flownav
