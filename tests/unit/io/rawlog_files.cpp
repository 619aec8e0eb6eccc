#include "rawlog_files.h"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>
#include <zlib.h>

#include <fstream>
#include <opencv2/core/mat.hpp>
#include <random>

#include "flownav/math/units.h"

namespace flownav::testing {

namespace fs = std::filesystem;

fs::path test_folder() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    fs::path folder =
        fs::path(::testing::TempDir()) / "flownav_replay_input" / test->test_suite_name() / test->name();
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

std::string serialized(const std::vector<mrpt::serialization::CSerializable::ConstPtr>& objects) {
    mrpt::io::CMemoryStream memory;
    auto archive = mrpt::serialization::archiveFrom(memory);
    for (const auto& object : objects) archive << *object;
    return {static_cast<const char*>(memory.getRawBufferData()), memory.getTotalBytesCount()};
}

std::string gz(const std::string& bytes) {
    z_stream z{};
    if (deflateInit2(&z, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK) return {};
    std::string out(deflateBound(&z, bytes.size()) + 64, '\0');
    z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    z.avail_in = static_cast<uInt>(bytes.size());
    z.next_out = reinterpret_cast<Bytef*>(out.data());
    z.avail_out = static_cast<uInt>(out.size());
    deflate(&z, Z_FINISH);
    out.resize(z.total_out);
    deflateEnd(&z);
    return out;
}

void write_bytes(const fs::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

mrpt::obs::CObservationImage::Ptr image_at(double timestamp_s, unsigned seed) {
    cv::Mat_<std::uint8_t> pixels(48, 64);
    std::minstd_rand random(seed);
    for (std::uint8_t& pixel : pixels) pixel = random() >> 8 & 0xFF;
    auto image = mrpt::obs::CObservationImage::Create();
    image->timestamp = mrpt::Clock::fromDouble(timestamp_s);
    image->sensorLabel = "CAMERA1";
    image->image = mrpt::img::CImage(pixels, mrpt::img::DEEP_COPY);
    image->cameraParams.ncols = 64;
    image->cameraParams.nrows = 48;
    image->cameraParams.setIntrinsicParamsFromValues(60, 50, 31.5, 23.5);
    image->cameraPose = mrpt::poses::CPose3D(0.1, 0.02, 0.5, -90 * degree_rad, 0, (-90 - 10) * degree_rad);
    return image;
}

mrpt::obs::CObservationOdometry::Ptr odometry_at(double timestamp_s, double x_m) {
    auto odometry = mrpt::obs::CObservationOdometry::Create();
    odometry->timestamp = mrpt::Clock::fromDouble(timestamp_s);
    odometry->sensorLabel = "ODOMETRY";
    odometry->odometry = mrpt::poses::CPose2D(x_m, 0, 0);
    return odometry;
}

mrpt::obs::CObservationRobotPose::Ptr truth_at(double timestamp_s, double x_m) {
    auto truth = mrpt::obs::CObservationRobotPose::Create();
    truth->timestamp = mrpt::Clock::fromDouble(timestamp_s);
    truth->sensorLabel = "GROUND_TRUTH";
    truth->pose.mean = mrpt::poses::CPose3D(x_m, 0, 0, 0, 0, 0);
    return truth;
}

std::vector<mrpt::serialization::CSerializable::ConstPtr> small_recording() {
    std::vector<mrpt::serialization::CSerializable::ConstPtr> objects;
    for (unsigned i = 0; i < 8; ++i) {
        const double t = 100 + 0.04 * i;
        objects.push_back(image_at(t, i + 1));
        objects.push_back(odometry_at(t, 0.01 * i));
        objects.push_back(truth_at(t, 0.01 * i));
    }
    return objects;
}

}  // namespace flownav::testing
