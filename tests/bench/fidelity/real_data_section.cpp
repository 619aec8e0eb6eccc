#include <cstdlib>

#include "real_data.h"
#include "sections.h"

namespace flownav::fidelity {

std::filesystem::path data_folder() {
    const char* given = std::getenv("FLOWNAV_DATA");
    return given != nullptr ? given : FLOWNAV_DATA;
}

std::string real_data_report(const RealDataOptions& options) {
    const std::filesystem::path data = options.data.empty() ? data_folder() : options.data;
    return "\n## Real drives\n\nPublic recordings; `flownav-fidelity` finds them where FLOWNAV_DATA "
           "points.\n" +
           braking_part(data / "kitti-raw" / "2011_09_26", options) + odometry_part(data / "kitti-odometry") +
           gyro_part(data / "donkeycar-gyro");
}

std::string real_data_section(const std::filesystem::path& folder, const std::string& stem) {
    RealDataOptions options;
    options.plan_svg = folder / (stem + "-kitti.svg");
    return real_data_report(options);
}

}  // namespace flownav::fidelity
