#include "throughput.h"

namespace flownav::bench {

#if defined(__x86_64__)
namespace {

// Twelve destination registers: more than latency times throughput on current processors. As inline assembly,
// the instructions are not optimised away and need no compiler flags.
#define FLOWNAV_TWELVE(before, after)                                                                        \
    before "0" after "\n" before "1" after "\n" before "2" after "\n" before "3" after "\n" before "4" after \
           "\n" before "5" after "\n" before "6" after "\n" before "7" after "\n" before "8" after           \
           "\n" before "9" after "\n" before "10" after "\n" before "11" after "\n"
#define FLOWNAV_REGISTERS \
    "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7", "xmm8", "xmm9", "xmm10", "xmm11"

void psadbw(std::int64_t iterations) {
    for (; iterations > 0; --iterations)
        asm volatile(FLOWNAV_TWELVE("psadbw %%xmm12, %%xmm", "") : : : FLOWNAV_REGISTERS);
}

void mpsadbw(std::int64_t iterations) {
    for (; iterations > 0; --iterations)
        asm volatile(FLOWNAV_TWELVE("mpsadbw $0, %%xmm12, %%xmm", "") : : : FLOWNAV_REGISTERS);
}

void vmpsadbw(std::int64_t iterations) {
    for (; iterations > 0; --iterations)
        asm volatile(FLOWNAV_TWELVE("vmpsadbw $0, %%ymm12, %%ymm13, %%ymm", "") : : : FLOWNAV_REGISTERS);
    asm volatile("vzeroupper" : : : FLOWNAV_REGISTERS);
}

void vdbpsadbw(std::int64_t iterations) {
    for (; iterations > 0; --iterations)
        asm volatile(FLOWNAV_TWELVE("vdbpsadbw $0, %%zmm12, %%zmm13, %%zmm", "") : : : FLOWNAV_REGISTERS);
    asm volatile("vzeroupper" : : : FLOWNAV_REGISTERS);
}

}  // namespace

const std::vector<Throughput>& throughput_table() {
    constexpr int differences = 16 * 16 * 256;
    // Differences per instruction: 16 (psadbw), 8 x 4, 16 x 4 or 32 x 4.
    static const std::vector<Throughput> table = {
        {"vdbpsadbw zmm", "avx512bw", differences / 128,
         [] { return __builtin_cpu_supports("avx512bw") != 0; }, vdbpsadbw},
        {"vmpsadbw ymm", "avx2", differences / 64, [] { return __builtin_cpu_supports("avx2") != 0; },
         vmpsadbw},
        {"mpsadbw xmm", "sse41", differences / 32, [] { return __builtin_cpu_supports("sse4.1") != 0; },
         mpsadbw},
        {"psadbw xmm", "portable", differences / 16, [] { return true; }, psadbw}};
    return table;
}
#else
const std::vector<Throughput>& throughput_table() {
    static const std::vector<Throughput> table;
    return table;
}
#endif

}  // namespace flownav::bench
