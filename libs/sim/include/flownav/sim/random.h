#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace flownav::sim {

/// A seeded stream of random numbers: the same with every standard library, whose distributions differ.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    std::uint64_t bits() { return engine_(); }

    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1.0p-53);
    }

    /// From low to high, both included.
    int integer(int low, int high) {
        const auto count = static_cast<std::uint64_t>(high - low) + 1U;
        return low + static_cast<int>(engine_() % count);
    }

    bool chance(double probability) { return uniform(0.0, 1.0) < probability; }

    /// Nearly normal, mean 0: the sum of four uniform numbers, within 3.5 sigma.
    double normal(double sigma) {
        double sum = -2.0;
        for (int i = 0; i < 4; ++i) sum += uniform(0.0, 1.0);
        return sigma * sum * std::sqrt(3.0);
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace flownav::sim
