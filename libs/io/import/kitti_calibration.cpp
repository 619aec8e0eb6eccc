#include "kitti_calibration.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <sstream>

#include "flownav/io/errors.h"
#include "flownav/io/kitti.h"
#include "flownav/math/units.h"
#include "import_files.h"

namespace flownav::io {
namespace {

std::string size_text(double width_px, double height_px) {
    std::ostringstream text;
    text << width_px << " x " << height_px;
    return text.str();
}

/// True for an image scaled in both directions alike, within the rounding of its sides.
bool same_shape(const std::vector<double>& size, int width_px, int height_px) {
    const double scale_x = width_px / size[0];
    const double scale_y = height_px / size[1];
    return std::abs(scale_x * size[1] - height_px) <= 1.0 || std::abs(scale_y * size[0] - width_px) <= 1.0;
}

/// The camera of the same image at another size; the middle of the first pixel is (0, 0).
void scale(CameraModel& camera, double scale_x, double scale_y) {
    camera.fx_px *= scale_x;
    camera.fy_px *= scale_y;
    camera.cx_px = (camera.cx_px + 0.5) * scale_x - 0.5;
    camera.cy_px = (camera.cy_px + 0.5) * scale_y - 0.5;
}

FoundCamera rectified(const KittiCalibration& calibration, const std::string& number, int width_px,
                      int height_px, const CameraMount& mount) {
    FoundCamera found;
    found.camera = kitti_camera(calibration, "P_rect_" + number, mount);
    const auto size = calibration.of("S_rect_" + number, 2);
    if (size.empty()) {
        found.note = calibration.file.string() + ": holds no S_rect_" + number +
                     "; the images are taken for rectified ones of the size that P_rect_" + number +
                     " is for";
    } else if (size[0] != width_px || size[1] != height_px) {
        scale(found.camera, width_px / size[0], height_px / size[1]);
        found.note = calibration.file.string() + ": is for images of " + size_text(size[0], size[1]) +
                     "; P_rect_" + number + " is scaled to these of " + size_text(width_px, height_px);
    }
    return found;
}

FoundCamera as_taken(const KittiCalibration& calibration, const std::string& number,
                     const CameraMount& mount) {
    const auto K = calibration.of("K_" + number, 9);
    const auto D = calibration.of("D_" + number, 5);
    const auto T = calibration.of("T_" + number, 3);
    if (K.empty() || D.empty() || !(K[0] > 0)) {
        throw InputError(calibration.file.string() +
                         ": the images are not rectified (a drive of the kind "
                         "_extract), and the file holds no K_" +
                         number + " (9 numbers) and D_" + number +
                         " (5 numbers) for them; take the drive of the kind _sync, or KITTI's own file");
    }
    FoundCamera found;
    found.camera.fx_px = K[0];
    found.camera.fy_px = K[4];
    found.camera.cx_px = K[2];
    found.camera.cy_px = K[5];
    for (std::size_t i = 0; i < 5; ++i) found.camera.distortion[i] = D[i];
    found.camera.mount = mount;
    if (!T.empty()) found.camera.mount.left_m += T[0];
    found.note = "the images are not rectified; they are used with K_" + number + " and the distortion D_" +
                 number + " of " + calibration.file.filename().string();
    return found;
}

}  // namespace

std::vector<double> KittiCalibration::of(const std::string& key, std::size_t count) const {
    const auto found = numbers.find(key);
    if (found == numbers.end() || found->second.size() != count) return {};
    return found->second;
}

KittiCalibration read_kitti_calibration(const std::filesystem::path& file) {
    KittiCalibration calibration;
    calibration.file = file;
    for (const std::string& line : read_lines(file)) {
        const auto colon = line.find(':');
        if (colon == std::string::npos) continue;
        auto numbers = numbers_of(line.substr(colon + 1));
        if (!numbers.empty()) calibration.numbers[line.substr(0, colon)] = std::move(numbers);
    }
    return calibration;
}

CameraModel kitti_camera(const KittiCalibration& calibration, const std::string& key,
                         const CameraMount& mount) {
    const auto P = calibration.of(key, 12);
    if (P.empty() || !(P[0] > 0)) {
        throw InputError(calibration.file.string() + ": holds no projection matrix " + key + " (12 numbers)");
    }
    CameraModel camera;
    camera.fx_px = P[0];
    camera.fy_px = P[5];
    camera.cx_px = P[2];
    camera.cy_px = P[6];
    camera.mount = mount;
    camera.mount.left_m += P[3] / P[0];
    return camera;
}

FoundCamera kitti_raw_camera(const KittiCalibration& calibration, const std::string& number, int width_px,
                             int height_px, const CameraMount& mount) {
    const auto size = calibration.of("S_" + number, 2);
    const auto rectified_size = calibration.of("S_rect_" + number, 2);
    const bool taken = !size.empty() && size != rectified_size && size[0] == width_px && size[1] == height_px;
    const bool is_rectified = rectified_size.empty() || same_shape(rectified_size, width_px, height_px);
    if (taken || (!is_rectified && width_px == 1392 && height_px == 512))
        return as_taken(calibration, number, mount);
    if (is_rectified) return rectified(calibration, number, width_px, height_px, mount);
    throw InputError(calibration.file.string() + ": the images have " + size_text(width_px, height_px) +
                     " pixels, but S_rect_" + number + " is " +
                     size_text(rectified_size[0], rectified_size[1]) +
                     (size.empty() ? "" : " and S_" + number + " is " + size_text(size[0], size[1])) +
                     ": this calibration is not theirs");
}

CameraMount kitti_mount(const std::string& day_or_sequence) {
    CameraMount mount;
    mount.height_m = 1.65;
    mount.forward_m = 1.1;
    const auto is_one_of = [&](std::initializer_list<const char*> names) {
        return std::find(names.begin(), names.end(), day_or_sequence) != names.end();
    };
    if (is_one_of({"2011_10_03", "00", "01", "02"})) {
        mount.pitch_rad = 0.1 * degree_rad;
        mount.roll_rad = -1.4 * degree_rad;
        mount.yaw_rad = -0.6 * degree_rad;
    } else if (is_one_of({"2011_09_26", "03"})) {
        mount.height_m = 1.66;
        mount.roll_rad = -0.2 * degree_rad;
    }
    return mount;
}

}  // namespace flownav::io
