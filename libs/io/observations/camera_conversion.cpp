#include "flownav/io/camera_conversion.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "flownav/core/pose2.h"
#include "flownav/math/units.h"
#include "turned_image.h"

namespace flownav::io {
namespace {

/// Calibration of a recording; absent values must come from the ini.
struct Recorded {
    std::optional<double> fx_px, fy_px, cx_px, cy_px;
    std::array<double, 5> distortion{};
    std::optional<CameraMount> mount;  ///< empty: no pose was recorded
    bool oriented = false;             ///< the recorded pose has a rotation to optical axes
    std::string unusable_lens;        ///< unsupported lens model of the recording; empty when it is supported
    int width_px = 0, height_px = 0;  ///< of the image that the intrinsics are for
    std::vector<std::string> notes;   ///< of CameraReading
};

constexpr double upright_deg = 10.0;  // larger roll or yaw is not compensated
constexpr double pitch_min_deg = -5.0, pitch_max_deg = 80.0;

bool looks_ahead(const CameraMount& m) {
    const double pitch_deg = deg(m.pitch_rad);
    return pitch_deg >= pitch_min_deg && pitch_deg <= pitch_max_deg &&
           std::abs(deg(m.yaw_rad)) <= upright_deg;
}

/// The rest of a roll after turning the image by quarters.
double roll_after_quarters_rad(double roll_rad, int rotate_deg) {
    return wrap_angle(roll_rad - rotate_deg * degree_rad);
}

/// The mount as recorded: by optical axes, or, when those would look elsewhere, by axes x forward and z up.
CameraMount recorded_mount(const mrpt::poses::CPose3D& pose, std::vector<std::string>& notes) {
    const CameraMount optical = camera_mount(pose);
    if (looks_ahead(optical)) return optical;
    const CameraMount x_forward = camera_mount(pose + mrpt::poses::CPose3D(0, 0, 0, -M_PI / 2, 0, -M_PI / 2));
    if (!looks_ahead(x_forward) || std::abs(deg(x_forward.roll_rad)) > upright_deg) return optical;
    notes.emplace_back("pose_x_forward");
    return x_forward;
}

/// Distance of a principal point from the middle of an image, in shares of its size.
double off_centre(double cx_px, double cy_px, int width_px, int height_px) {
    return std::max(std::abs((cx_px + 0.5) / width_px - 0.5), std::abs((cy_px + 0.5) / height_px - 0.5));
}

Recorded recorded_calibration(const mrpt::obs::CObservationImage& image) {
    Recorded r;
    const mrpt::img::TCamera& c = image.cameraParams;
    if (c.fx() > 0 && c.fy() > 0) {
        r.fx_px = c.fx();
        r.fy_px = c.fy();
        r.cx_px = c.cx();
        r.cy_px = c.cy();
    }
    const bool lens = c.distortion == mrpt::img::DistortionModel::plumb_bob;
    if (lens) r.distortion = {c.dist[0], c.dist[1], c.dist[2], c.dist[3], c.dist[4]};
    if (lens && (c.dist[5] != 0 || c.dist[6] != 0 || c.dist[7] != 0))
        r.unusable_lens = "plumb_bob with k4..k6";
    if (c.distortion == mrpt::img::DistortionModel::kannala_brandt) r.unusable_lens = "kannala_brandt";
    const auto R = image.cameraPose.getRotationMatrix();
    r.oriented = std::abs(R(0, 0) - 1) > 1e-6 || std::abs(R(1, 1) - 1) > 1e-6;
    if (r.oriented) r.mount = recorded_mount(image.cameraPose, r.notes);
    if (!r.oriented && image.cameraPose.norm() > 0) r.mount = camera_mount(image.cameraPose);
    r.width_px = static_cast<int>(c.ncols);
    r.height_px = static_cast<int>(c.nrows);
    return r;
}

/// Converts intrinsics of another image size. A recorded size that is out of date, while the intrinsics fit
/// the image better, is noted only. Throws ConfigError when the shapes differ.
void fit_size(Recorded& r, int width_px, int height_px) {
    const bool known = r.fx_px && r.width_px > 0 && r.height_px > 0;
    if (!known || (r.width_px == width_px && r.height_px == height_px)) return;
    if (off_centre(*r.cx_px, *r.cy_px, width_px, height_px) <=
        off_centre(*r.cx_px, *r.cy_px, r.width_px, r.height_px)) {
        r.notes.emplace_back("calibration_of_another_size");
        return;
    }
    constexpr double shape_tolerance = 0.01;
    const double across = static_cast<double>(width_px) / r.width_px;
    const double down = static_cast<double>(height_px) / r.height_px;
    if (std::abs(across / down - 1.0) > shape_tolerance) {
        const auto size = [](int w, int h) { return std::to_string(w) + " x " + std::to_string(h); };
        throw config::ConfigError("the recorded calibration is for images of " +
                                  size(r.width_px, r.height_px) + " pixels, but the images have " +
                                  size(width_px, height_px) +
                                  ", another shape: calibrate the camera at this size, or set camera.fx_px, "
                                  "fy_px, cx_px and cy_px for it");
    }
    r.fx_px = *r.fx_px * across;
    r.fy_px = *r.fy_px * down;
    r.cx_px = (*r.cx_px + 0.5) * across - 0.5;
    r.cy_px = (*r.cy_px + 0.5) * down - 0.5;
    r.notes.emplace_back("calibration_scaled");
}

void require_finite(const CameraModel& c) {
    const auto bad = [](double x) { return !std::isfinite(x); };
    bool any = bad(c.fx_px) || bad(c.fy_px) || bad(c.cx_px) || bad(c.cy_px) || bad(c.mount.height_m) ||
               bad(c.mount.forward_m) || bad(c.mount.left_m) || bad(c.mount.pitch_rad);
    for (const double k : c.distortion) any = any || bad(k);
    if (any) {
        throw config::ConfigError(
            "the recorded calibration of the camera holds a value that is no number: "
            "set camera.fx_px, fy_px, cx_px, cy_px, distortion, height_m and pitch_deg");
    }
}

void require_range(const char* key, double value, double low, double high, const char* hint) {
    if (value >= low && value <= high) return;
    std::ostringstream text;
    text << key << " = " << value << " is out of range (" << low << " .. " << high << "): " << hint;
    throw config::ConfigError(text.str());
}

/// Throws ConfigError when intrinsics cannot be pixels of this image. A focal length below 0.04 of the image
/// size would mean a view of more than 171 degrees, impossible with this lens model.
void require_pixels(const CameraModel& c) {
    constexpr double shortest = 0.04;
    constexpr double longest_px = 50000.0;
    const char* const pixels =
        "are these pixels? Values in millimetres, or shares of the image, have to be turned into pixels of "
        "this image. Correct the recorded cameraParams, or set camera.fx_px, fy_px, cx_px and cy_px";
    require_range("camera.fx_px", c.fx_px, std::max(1.0, shortest * c.width_px), longest_px, pixels);
    require_range("camera.fy_px", c.fy_px, std::max(1.0, shortest * c.height_px), longest_px, pixels);
    require_range("camera.cx_px", c.cx_px, -2.0 * c.width_px, 3.0 * c.width_px, pixels);
    require_range("camera.cy_px", c.cy_px, -2.0 * c.height_px, 3.0 * c.height_px, pixels);
    for (const double k : c.distortion) {
        require_range("camera.distortion", k, -100, 100,
                      "this bends no lens. Correct the recorded distortion or set camera.distortion");
    }
}

/// Throws ConfigError, which names the key, when the camera is rolled by a quarter, or upside down.
void require_upright(double roll_rad) {
    for (const int rotate_deg : {90, 180, 270}) {
        if (std::abs(deg(roll_after_quarters_rad(roll_rad, rotate_deg))) > upright_deg) continue;
        std::ostringstream text;
        text << "the recorded cameraPose is rolled by " << std::lround(deg(roll_rad))
             << " deg: set camera.rotate = " << rotate_deg
             << ", which turns the images upright as they are read";
        throw config::ConfigError(text.str());
    }
}

void require_usable_mount(const CameraMount& m) {
    require_range("camera.height_m", m.height_m, 0.01, 20,
                  "the camera's height over the ground in metres. Correct the recorded cameraPose or set "
                  "camera.height_m");
    require_range("camera.pitch_deg", m.pitch_rad / degree_rad, -5, 80,
                  "the camera has to look ahead or down; > 0 looks down. Correct the recorded cameraPose or "
                  "set camera.pitch_deg");
    require_upright(m.roll_rad);
    require_range("camera.roll_deg", m.roll_rad / degree_rad, -10, 10,
                  "a camera tilted sideways this far is not compensated. Correct the recorded cameraPose or "
                  "set camera.roll_deg");
    require_range(
        "camera.forward_m", m.forward_m, -10, 10,
        "the camera's place ahead of the robot's axis in metres. Correct the recorded cameraPose or "
        "set camera.forward_m");
    require_range("camera.left_m", m.left_m, -10, 10,
                  "the camera's place beside the robot's axis in metres. Correct the recorded cameraPose or "
                  "set camera.left_m");
    require_range("camera.yaw_deg", m.yaw_rad / degree_rad, -10, 10,
                  "the camera has to look ahead. Correct the recorded cameraPose or set camera.yaw_deg");
}

std::string missing_keys(const Recorded& r, const config::CameraConfig& c) {
    std::string keys;
    const auto need = [&keys](bool there, const char* key) {
        if (!there) keys += (keys.empty() ? "camera." : ", camera.") + std::string(key);
    };
    need(r.fx_px || c.fx_px, "fx_px");
    need(r.fy_px || c.fy_px, "fy_px");
    need(r.cx_px || c.cx_px, "cx_px");
    need(r.cy_px || c.cy_px, "cy_px");
    need(r.mount || c.height_m, "height_m");
    need(r.oriented || c.pitch_deg, "pitch_deg");
    return keys;
}

CameraMount merged_mount(const Recorded& r, const config::CameraConfig& c) {
    CameraMount mount = r.mount.value_or(CameraMount{});
    if (!r.oriented) mount.pitch_rad = mount.roll_rad = mount.yaw_rad = 0;
    const double upright_rad = roll_after_quarters_rad(mount.roll_rad, c.rotate_deg);
    if (std::abs(deg(upright_rad)) <= upright_deg) mount.roll_rad = upright_rad;  // else of the turned image
    mount.height_m = c.height_m.value_or(mount.height_m);
    mount.forward_m = c.forward_m.value_or(mount.forward_m);
    mount.left_m = c.left_m.value_or(mount.left_m);
    if (c.pitch_deg) mount.pitch_rad = *c.pitch_deg * degree_rad;
    if (c.roll_deg) mount.roll_rad = *c.roll_deg * degree_rad;
    if (c.yaw_deg) mount.yaw_rad = *c.yaw_deg * degree_rad;
    return mount;
}

CameraModel merged(const Recorded& r, const config::CameraConfig& c, int width_px, int height_px) {
    const std::string missing = missing_keys(r, c);
    if (!missing.empty()) {
        throw config::ConfigError("no calibration of the camera '" + c.camera_label +
                                  "': neither the images nor the ini "
                                  "give " +
                                  missing + "; set these keys in the [camera] section");
    }
    if (!r.unusable_lens.empty() && !c.distortion) {
        throw config::ConfigError("camera.distortion: the recorded lens model " + r.unusable_lens +
                                  " is not supported (allowed: none, plumb_bob with k1 k2 p1 p2 k3); set "
                                  "camera.distortion or undistort the images (rawlog-edit --undistort)");
    }
    CameraModel camera;
    camera.width_px = width_px;
    camera.height_px = height_px;
    camera.fx_px = c.fx_px ? *c.fx_px : *r.fx_px;
    camera.fy_px = c.fy_px ? *c.fy_px : *r.fy_px;
    camera.cx_px = c.cx_px ? *c.cx_px : *r.cx_px;
    camera.cy_px = c.cy_px ? *c.cy_px : *r.cy_px;
    camera.distortion = c.distortion.value_or(r.distortion);
    if (c.distortion) camera.lens = &find_lens(c.lens);
    camera.mount = merged_mount(r, c);
    require_finite(camera);
    require_pixels(camera);
    require_usable_mount(camera.mount);
    return camera;
}

}  // namespace

CameraMount camera_mount(const mrpt::poses::CPose3D& pose_robot_camera) {
    const auto R = pose_robot_camera.getRotationMatrix();
    CameraMount m;
    m.forward_m = pose_robot_camera.x();
    m.left_m = pose_robot_camera.y();
    m.height_m = pose_robot_camera.z();
    // The columns of R are the camera's right, down and forward axes in robot axes (forward, left, up).
    m.pitch_rad = std::asin(std::clamp(-R(2, 2), -1.0, 1.0));
    m.yaw_rad = std::atan2(R(1, 2), R(0, 2));
    m.roll_rad = std::atan2(-R(2, 0), -R(2, 1));
    return m;
}

mrpt::poses::CPose3D camera_pose(const CameraMount& m) {
    const mrpt::poses::CPose3D pose_robot_level(m.forward_m, m.left_m, m.height_m, m.yaw_rad, m.pitch_rad,
                                                m.roll_rad);
    return pose_robot_level + mrpt::poses::CPose3D(0, 0, 0, -M_PI / 2, 0, -M_PI / 2);
}

mrpt::img::TCamera camera_params(const CameraModel& camera) {
    mrpt::img::TCamera c;
    c.ncols = static_cast<uint32_t>(camera.width_px);
    c.nrows = static_cast<uint32_t>(camera.height_px);
    c.setIntrinsicParamsFromValues(camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px);
    if (camera.lens != &brown_conrady())
        throw std::invalid_argument("a rawlog cannot hold the camera's lens " + camera.lens->name());
    const auto& k = camera.distortion;
    if (k != std::array<double, 5>{}) c.setDistortionPlumbBob(k[0], k[1], k[2], k[3], k[4]);
    return c;
}

CameraModel camera_model(const config::CameraConfig& config, int width_px, int height_px) {
    return merged(Recorded{}, config, width_px, height_px);
}

CameraReading read_camera(const mrpt::obs::CObservationImage& image, const config::CameraConfig& config,
                          int width_px, int height_px) {
    constexpr double off_centre_max = 0.22;
    constexpr double exchanged_min = 0.08;  // across and down were exchanged
    Recorded recorded = recorded_calibration(image);
    if (!config.fx_px || !config.fy_px || !config.cx_px || !config.cy_px)
        fit_size(recorded, width_px, height_px);
    CameraReading reading{merged(recorded, config, width_px, height_px), std::move(recorded.notes)};
    const CameraModel& c = reading.camera;
    const double off = off_centre(c.cx_px, c.cy_px, width_px, height_px);
    const double exchanged = off_centre(c.cy_px, c.cx_px, width_px, height_px);
    if (off > off_centre_max || off - exchanged > exchanged_min)
        reading.notes.emplace_back("principal_point_off_centre");
    reading.camera = turned(reading.camera, config);
    return reading;
}

CameraModel field_camera(const CameraModel& frame, bool bottom) {
    CameraModel field = frame;
    field.height_px = frame.height_px / 2;
    field.fy_px = frame.fy_px / 2;
    field.cy_px = (frame.cy_px - (bottom ? 1 : 0)) / 2;
    return field;
}

}  // namespace flownav::io
