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

/// Mixes 64 bits thoroughly (the finaliser of SplitMix64).
constexpr std::uint64_t mix(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15U;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
    return x ^ (x >> 31U);
}

constexpr std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
    return mix(mix(a) ^ b);
}

/// Nearly normal number of mean 0 and variance 1 from 64 random bits: the sum of four uniform numbers of 16
/// bits. Uses exact arithmetic and sqrt only: the same bits give the same number on every machine.
inline double normal_of_bits(std::uint64_t bits) {
    const std::uint64_t sum =
        (bits & 0xFFFFU) + ((bits >> 16U) & 0xFFFFU) + ((bits >> 32U) & 0xFFFFU) + (bits >> 48U);
    return (static_cast<double>(sum) / 65536.0 - 2.0 + 2.0 / 65536.0) * std::sqrt(3.0);
}

/// A stream of random numbers made by mix() of a counter. Cheap to seed: one for each texture and each image.
class HashRandom {
  public:
    explicit HashRandom(std::uint64_t seed) : state_(mix(seed)) {}

    std::uint64_t bits() { return mix(++state_); }
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11U) * 0x1.0p-53);
    }
    double normal(double sigma) { return sigma * normal_of_bits(bits()); }

  private:
    std::uint64_t state_;
};

}  // namespace flownav::sim
