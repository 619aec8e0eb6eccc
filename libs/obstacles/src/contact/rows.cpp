#include "rows.h"

namespace flownav::obstacles::rows {

namespace portable {
extern const Functions table;
}
#ifdef FLOWNAV_X86_ROWS
namespace avx2 {
extern const Functions table;
}
#endif

const Functions& functions() {
#ifdef FLOWNAV_X86_ROWS
    static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
    if (has_avx2) return avx2::table;
#endif
    return portable::table;
}

const Functions& portable_functions() {
    return portable::table;
}

}  // namespace flownav::obstacles::rows
