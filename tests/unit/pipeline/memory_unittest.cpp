#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "drives.h"

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

}  // namespace
}  // namespace flownav
