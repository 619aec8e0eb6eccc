#pragma once
#include <cstdint>
#include <vector>

namespace flownav::bench {

/// Maximum throughput of an instruction that sums absolute differences: independent instructions only.
struct Throughput {
    const char* instruction;
    const char* kernel;   ///< the kernel that it limits
    int per_vector;       ///< instructions for a 16x16 block at 256 offsets: 65,536 absolute differences
    bool (*supported)();  ///< by this processor
    void (*run)(std::int64_t iterations);  ///< runs throughput_unrolled instructions per iteration
};

constexpr int throughput_unrolled = 12;

/// Empty on processors without such an instruction.
const std::vector<Throughput>& throughput_table();

}  // namespace flownav::bench
