#include "test_sensor.h"

#include <fcntl.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>
#include <unistd.h>

#include <chrono>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <thread>

IMPLEMENTS_GENERIC_SENSOR(CTestSensor, flownav::testing)

namespace flownav::testing {

void CTestSensor::loadConfig_sensorSpecific(const mrpt::config::CConfigFileBase& ini,
                                            const std::string& section) {
    section_ = section;
    journal_ = ini.read_string(section, "journal", "");
    turns_ = ini.read_int(section, "turns", 0);
    then_ = ini.read_string(section, "then", "nothing");
    image_ = ini.read_bool(section, "image", false);
    lag_s_ = ini.read_double(section, "lag_s", 0.0);
    if (ini.read_bool(section, "refuse", false)) throw std::runtime_error("the key refuse is set");
}

void CTestSensor::initialize() {
    if (then_ == "no_device") throw std::runtime_error("no such device");
}

void CTestSensor::doProcess() {
    if (turns_ == 0 || turn_ < turns_) return observe();
    if (then_ == "throw") {
        observe();  // must still be saved
        throw std::runtime_error("the cable was pulled");
    }
    if (then_ == "error") m_state = ssError;
    if (then_ == "end") throw mrpt::serialization::CExceptionEOF("the end of the file");
    while (then_ == "hang") std::this_thread::sleep_for(std::chrono::seconds(1));
}

void CTestSensor::observe() {
    const auto now = mrpt::Clock::fromDouble(mrpt::Clock::toDouble(mrpt::Clock::now()) - lag_s_);
    auto odometry = mrpt::obs::CObservationOdometry::Create();
    odometry->timestamp = now;
    odometry->sensorLabel = section_;
    odometry->odometry.x(turn_++);
    note(section_, now);
    appendObservation(odometry);
    if (!image_) return;
    auto image = mrpt::obs::CObservationImage::Create();
    cv::Mat pixels(288, 768, CV_8UC1);
    cv::randu(pixels, 0, 64);
    image->image = mrpt::img::CImage(pixels, mrpt::img::SHALLOW_COPY);
    image->timestamp = now;
    image->sensorLabel = section_ + "_IMAGE";
    note(image->sensorLabel, now);
    appendObservation(image);
}

void CTestSensor::note(const std::string& label, mrpt::Clock::time_point time) const {
    if (journal_.empty()) return;
    const std::string line = label + ' ' + std::to_string(time.time_since_epoch().count()) + '\n';
    const int file = open(journal_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (write(file, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
        throw std::runtime_error("cannot write the journal");
    close(file);
}

}  // namespace flownav::testing
