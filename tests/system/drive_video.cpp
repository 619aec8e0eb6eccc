#include "drive_video.h"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <opencv2/core/mat.hpp>
#include <opencv2/videoio.hpp>
#include <sstream>
#include <variant>
#include <vector>

#include "flownav/io/field_source.h"
#include "flownav/math/units.h"

namespace flownav::testing {
namespace {

std::vector<Field> fields_of(const std::string& rawlog) {
    io::RawlogReader reader(rawlog);
    io::FieldSource source(reader, config::CameraConfig{});
    std::vector<Field> fields;
    while (const auto event = source.next()) {
        if (const auto* field = std::get_if<Field>(&*event)) fields.push_back(*field);
    }
    return fields;
}

cv::Mat pixels(const Field& field) {
    const ImageView& view = field.image;
    return {view.height_px, view.width_px, CV_8UC1, const_cast<std::uint8_t*>(view.data),
            static_cast<std::size_t>(view.stride_bytes)};
}

cv::Mat woven(const Field& top, const Field& bottom) {
    cv::Mat frame(2 * top.image.height_px, top.image.width_px, CV_8UC1);
    for (int v = 0; v < top.image.height_px; ++v) {
        pixels(top).row(v).copyTo(frame.row(2 * v));
        pixels(bottom).row(v).copyTo(frame.row(2 * v + 1));
    }
    return frame;
}

/// Ini of a camera whose images are `lines` times as high as the fields.
std::string camera_ini(const CameraModel& camera, int lines) {
    const CameraMount& mount = camera.mount;
    std::ostringstream ini;
    ini << std::setprecision(17) << "[camera]\ninterlaced = " << (lines == 2 ? "top_first" : "none")
        << "\nfx_px = " << camera.fx_px << "\nfy_px = " << lines * camera.fy_px
        << "\ncx_px = " << camera.cx_px << "\ncy_px = " << lines * camera.cy_px
        << "\nheight_m = " << mount.height_m << "\nforward_m = " << mount.forward_m
        << "\nleft_m = " << mount.left_m << "\npitch_deg = " << mount.pitch_rad / degree_rad
        << "\nroll_deg = " << mount.roll_rad / degree_rad << "\nyaw_deg = " << mount.yaw_rad / degree_rad
        << '\n';
    return ini.str();
}

}  // namespace

std::string make_drive_video(const std::string& rawlog, const std::filesystem::path& folder) {
    const auto fields = fields_of(rawlog);
    const auto video = folder / "drive.avi", ini = folder / "camera.ini";
    const std::size_t lines = fields[0].camera.cy_px == fields[1].camera.cy_px ? 1 : 2;
    const double last_s = fields.back().timestamp_s - fields[0].timestamp_s;
    const double rate_hz = static_cast<double>(fields.size() - 1) / last_s / static_cast<double>(lines);
    std::ofstream(ini) << camera_ini(fields[0].camera, static_cast<int>(lines));
    const ImageView& view = fields[0].image;
    cv::VideoWriter writer(video.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('F', 'F', 'V', '1'),
                           std::round(rate_hz * 10) / 10,
                           {view.width_px, static_cast<int>(lines) * view.height_px}, false);
    for (std::size_t i = 0; i + lines <= fields.size(); i += lines)
        writer.write(lines == 2 ? woven(fields[i], fields[i + 1]) : pixels(fields[i]));
    std::ostringstream text;
    text << std::setprecision(17) << "grabber_type = ffmpeg\nffmpeg_url = " << video.string()
         << "\nflownav_config = " << ini.string() << "\nstart_time_s = " << fields[0].timestamp_s << '\n';
    return text.str();
}

}  // namespace flownav::testing
