#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <new>

namespace flownav::testing {

/// Memory between two guard pages: an access outside it crashes.
class GuardedMemory {
  public:
    explicit GuardedMemory(std::size_t pages) : page_(sysconf(_SC_PAGESIZE)), bytes_((pages + 2) * page_) {
        void* memory = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED) throw std::bad_alloc();
        all_ = static_cast<std::uint8_t*>(memory);
        mprotect(all_, page_, PROT_NONE);
        mprotect(all_ + bytes_ - page_, page_, PROT_NONE);
    }
    ~GuardedMemory() { munmap(all_, bytes_); }
    GuardedMemory(const GuardedMemory&) = delete;
    GuardedMemory& operator=(const GuardedMemory&) = delete;

    std::uint8_t* begin() const { return all_ + page_; }
    std::uint8_t* end() const { return all_ + bytes_ - page_; }

  private:
    std::size_t page_, bytes_;
    std::uint8_t* all_ = nullptr;
};

}  // namespace flownav::testing
