#include "flownav/drive/clock.h"

#include <thread>

namespace flownav::drive {

double system_time_s() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

SteadyClock::SteadyClock() : began_s_(system_time_s()) {}

double SteadyClock::now_s() const {
    return began_s_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

void SteadyClock::wait_until_s(double time_s) {
    const std::chrono::duration<double> since_began(time_s - began_s_);
    std::this_thread::sleep_until(
        began_ + std::chrono::duration_cast<std::chrono::steady_clock::duration>(since_began));
}

double SteadyClock::from_system_s(double system_s) const {
    return now_s() - (system_time_s() - system_s);
}

}  // namespace flownav::drive
