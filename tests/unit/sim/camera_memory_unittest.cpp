#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <opencv2/core.hpp>

#include "flownav/sim/camera_simulator.h"

namespace flownav::sim {
namespace {

/// Allocates OpenCV matrices right before a guard page, so that a write beyond their end crashes. The image
/// that OpenGL is read back into is such a matrix.
class GuardedAllocator : public cv::MatAllocator {
  public:
    cv::UMatData* allocate(int dims, const int* sizes, int type, void* data, std::size_t* step,
                           cv::AccessFlag /*flags*/, cv::UMatUsageFlags /*usage*/) const override {
        std::size_t total = CV_ELEM_SIZE(type);
        for (int i = dims - 1; i >= 0; --i) {
            if (step) step[i] = total;
            total *= static_cast<std::size_t>(sizes[i]);
        }
        auto* const u = new cv::UMatData(this);
        u->size = total;
        if (data) {
            u->data = u->origdata = static_cast<uchar*>(data);
            u->flags |= cv::UMatData::USER_ALLOCATED;
            return u;
        }
        auto* const pages = static_cast<uchar*>(
            mmap(nullptr, bytes(total), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
        if (pages == MAP_FAILED) throw std::bad_alloc();
        uchar* const guard = pages + bytes(total) - page_size();
        mprotect(guard, page_size(), PROT_NONE);
        u->origdata = pages;
        u->data = guard - total;
        return u;
    }
    bool allocate(cv::UMatData* u, cv::AccessFlag, cv::UMatUsageFlags) const override { return u != nullptr; }
    void deallocate(cv::UMatData* u) const override {
        if (!(u->flags & cv::UMatData::USER_ALLOCATED)) munmap(u->origdata, bytes(u->size));
        delete u;
    }

  private:
    static std::size_t page_size() { return static_cast<std::size_t>(sysconf(_SC_PAGESIZE)); }
    /// Whole pages for `total` bytes, plus the guard page.
    static std::size_t bytes(std::size_t total) {
        return (total + page_size() - 1) / page_size() * page_size() + page_size();
    }
};

class CameraMemory : public ::testing::TestWithParam<int> {
  protected:
    CameraMemory() : usual_(cv::Mat::getDefaultAllocator()) { cv::Mat::setDefaultAllocator(&guarded_); }
    ~CameraMemory() override { cv::Mat::setDefaultAllocator(usual_); }

    /// An image without noise; the optics of the camera do not depend on the image width.
    static Field image_of(int width_px, const std::array<double, 5>& distortion = {}) {
        CameraSimParams params;
        params.camera.width_px = width_px;
        params.camera.height_px = 48;
        params.camera.fx_px = params.camera.fy_px = 200.0;
        params.camera.cx_px = 30.0;
        params.camera.cy_px = 24.0;
        params.camera.distortion = distortion;
        params.camera.mount.height_m = 0.5;
        params.camera.mount.pitch_rad = 0.3;
        params.effects.noise_sigma = 0.0;
        params.supersampling = 1;
        World world;
        world.floor.surface = Surface::Patterned;
        CameraSimulator camera(world, params);
        return camera.take(0, {}, 0.0);
    }

  private:
    cv::MatAllocator* usual_;
    GuardedAllocator guarded_;
};

TEST_P(CameraMemory, NothingIsWrittenBeyondAnImageOfAnyWidth) {
    const Field field = image_of(GetParam());
    ASSERT_EQ(field.image.width_px, GetParam());
    const Field wide = image_of((GetParam() + 7) / 4 * 4);
    // Another width changes the rounding of single pixels; shifted rows would change most pixels.
    int different = 0;
    for (int v = 0; v < field.image.height_px; ++v) {
        for (int u = 0; u < field.image.width_px; ++u)
            different += std::abs(field.image.at(u, v) - wide.image.at(u, v)) > 4;
    }
    EXPECT_LT(different, field.image.width_px * field.image.height_px / 50);
}

TEST_P(CameraMemory, NothingIsWrittenBeyondTheImageOfABendingLens) {
    const Field field = image_of(GetParam(), {-0.1, 0.02, 0.0, 0.0, 0.0});
    EXPECT_EQ(field.image.width_px, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Widths, CameraMemory, ::testing::Values(65, 66, 67, 321, 322, 643));

}  // namespace
}  // namespace flownav::sim
