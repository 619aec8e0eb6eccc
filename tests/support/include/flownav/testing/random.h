#pragma once
#include <cmath>
#include <cstdint>

namespace flownav::testing {

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

/// Nearly normal number of mean 0 and variance 1 from 64 random bits: the sum of four uniform ones. It needs
/// no function of the maths library, so the same bits give the same number on every machine.
inline double normal_of_bits(std::uint64_t bits) {
    const std::uint64_t sum =
        (bits & 0xFFFFU) + ((bits >> 16U) & 0xFFFFU) + ((bits >> 32U) & 0xFFFFU) + (bits >> 48U);
    return (static_cast<double>(sum) / 65536.0 - 2.0 + 2.0 / 65536.0) * std::sqrt(3.0);
}

/// A seeded stream of random numbers: the same on every machine and with every standard library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(mix(seed)) {}

    std::uint64_t bits() { return mix(++state_); }
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11U) * 0x1.0p-53);
    }
    double normal(double sigma) { return sigma * normal_of_bits(bits()); }

  private:
    std::uint64_t state_;
};

}  // namespace flownav::testing
