#pragma once
#include <cstdint>
#include <vector>

namespace flownav::bench {

/// What an instruction that sums absolute differences could do at most: independent ones, nothing else.
struct Throughput {
    const char* instruction;
    const char* kernel;                    ///< whose limit it is
    int per_vector;                        ///< for a 16x16 block at 256 offsets: 65,536 absolute differences
    bool (*supported)();                   ///< by this processor
    void (*run)(std::int64_t iterations);  ///< of throughput_unrolled instructions each
};

constexpr int throughput_unrolled = 12;

/// Empty where no such instruction is known.
const std::vector<Throughput>& throughput_table();

}  // namespace flownav::bench
