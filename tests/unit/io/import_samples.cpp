#include "import_samples.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

namespace flownav::testing {

cv::Mat sample_picture(int offset) {
    cv::Mat pixels(48, 64, CV_8UC1);
    for (int v = 0; v < pixels.rows; ++v) pixels.row(v).setTo(3 * v + offset);
    return pixels;
}

void write_sample_picture(const std::filesystem::path& file, int offset) {
    std::filesystem::create_directories(file.parent_path());
    cv::imwrite(file.string(), sample_picture(offset));
}

config::CameraConfig sample_camera() {
    config::CameraConfig camera;
    camera.fx_px = camera.fy_px = 60;
    camera.cx_px = 31.5;
    camera.cy_px = 23.5;
    camera.height_m = 0.5;
    camera.pitch_deg = 10;
    return camera;
}

std::vector<double> times_of(io::ImageSequence& sequence) {
    std::vector<double> times_s;
    while (const auto frame = sequence.next()) times_s.push_back(frame->field.timestamp_s);
    return times_s;
}

void expect_times(const std::vector<double>& times_s, const std::vector<double>& expected_s) {
    ASSERT_EQ(times_s.size(), expected_s.size());
    for (std::size_t i = 0; i < times_s.size(); ++i) EXPECT_NEAR(times_s[i], expected_s[i], 1e-6) << i;
}

bool some_says(const std::vector<std::string>& sentences, std::initializer_list<const char*> parts) {
    return std::any_of(sentences.begin(), sentences.end(), [&](const std::string& sentence) {
        return std::all_of(parts.begin(), parts.end(),
                           [&](const char* part) { return sentence.find(part) != std::string::npos; });
    });
}

void expect_parts(const std::string& message, std::initializer_list<const char*> parts) {
    for (const char* part : parts)
        EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
}

}  // namespace flownav::testing
