#include "producer_samples.h"

#include <mrpt/config/CConfigFileMemory.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <random>
#include <variant>

#include "flownav/io/rawlog_reader.h"

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/lsan_interface.h>
#endif

/// Suppresses leaks of the libraries behind MRPT's grabbers.
extern "C" const char* __lsan_default_suppressions();   // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
    return "leak:libavutil\nleak:libusb\n";
}

namespace flownav::testing {

namespace fs = std::filesystem;

const std::string calibration_lines =
    "camera.fx_px = 60\ncamera.fy_px = 60\ncamera.cx_px = 31.5\ncamera.cy_px = 23.5\n"
    "camera.height_m = 0.5\ncamera.pitch_deg = 10\n";

fs::path producer_folder() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    fs::path folder =
        fs::path(::testing::TempDir()) / "flownav_producer" / test->test_suite_name() / test->name();
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

io::ProducerSettings producer_settings(const std::string& lines) {
    const mrpt::config::CConfigFileMemory ini("[FLOW]\ndriver = CFlowObstacleSensor\n" + lines);
    return io::read_producer_settings(ini, "FLOW");
}

std::vector<cv::Mat> noise_images(int count) {
    std::minstd_rand random(7);
    std::vector<cv::Mat> images;
    for (int i = 0; i < count; ++i) {
        cv::Mat_<std::uint8_t> image(48, 64);
        for (std::uint8_t& pixel : image) pixel = random() >> 8 & 0xFF;
        images.push_back(image);
    }
    return images;
}

void write_video(const fs::path& file, const std::vector<cv::Mat>& images, double rate_hz) {
    cv::VideoWriter writer(file.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('F', 'F', 'V', '1'),
                           rate_hz, images.front().size(), false);
    ASSERT_TRUE(writer.isOpened()) << file;
    for (const cv::Mat& image : images) writer.write(image);
}

void write_images(const fs::path& folder, const std::vector<cv::Mat>& images) {
    fs::create_directories(folder);
    for (std::size_t i = 0; i < images.size(); ++i) {
        const std::string number = std::to_string(1000 + i).substr(1);
        ASSERT_TRUE(cv::imwrite(folder / ("image_" + number + ".png"), images[i]));
    }
}

std::vector<Field> all_fields(io::LiveFields& live) {
    std::vector<Field> fields;
    while (const auto event = live.next()) {
        if (const auto* field = std::get_if<Field>(&*event)) fields.push_back(*field);
    }
    EXPECT_TRUE(live.ended());
    return fields;
}

std::string reason_not_to_open(const std::string& lines) {
#if defined(__SANITIZE_ADDRESS__)
    const __lsan::ScopedDisabler
        drivers_are_unloaded;  // unloaded libraries have no name to suppress their leaks by
#endif
    try {
        io::LiveFields live(producer_settings(lines));
    } catch (const io::InputError& error) {
        return error.what();
    } catch (const config::ConfigError& error) {
        return error.what();
    }
    return "it was opened";
}

}  // namespace flownav::testing
