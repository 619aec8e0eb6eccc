#include "flownav/drive/camera_thread.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

#include "flownav/config/make_state.h"
#include "flownav/pipeline/pipeline.h"

namespace flownav::drive {
namespace {

constexpr double nap_s = 0.05;  // interval at which the thread checks for its end

bool is_recording(const io::ProducerSettings& settings) {
    const bool stream =
        settings.source.find("://") != std::string::npos && settings.source.rfind("file://", 0) != 0;
    return settings.grabber_type == "rawlog" || settings.grabber_type == "image_dir" ||
           (settings.grabber_type == "ffmpeg" && !stream);
}

}  // namespace

CameraThread::CameraThread(const io::ProducerSettings& settings, const SteadyClock& clock, FieldSink sink)
    : fields_(settings),
      clock_(clock),
      sink_(std::move(sink)),
      recorded_(is_recording(settings)),
      thread_([this] { run(); }) {}

CameraThread::~CameraThread() {
    stops_ = true;
    thread_.join();
}

void CameraThread::odometry(const nav::WheelReading& reading) {
    const std::lock_guard lock(mutex_);
    wheels_.push_back({reading.time_s, reading.T_odom_robot});
}

std::vector<WheelPose> CameraThread::new_wheels() {
    const std::lock_guard lock(mutex_);
    return std::exchange(wheels_, {});
}

std::vector<nav::SensorUpdate> CameraThread::arrived() {
    const std::lock_guard lock(mutex_);
    return std::exchange(arrived_, {});
}

std::string CameraThread::end() {
    const std::lock_guard lock(mutex_);
    return end_;
}

void CameraThread::run() {
    std::string why;
    try {
        read_fields();
        why = fields_.error().empty() ? "the camera's source has ended" : fields_.error();
    } catch (const std::exception& error) {
        why = std::string("the camera's thread failed: ") + error.what();
    }
    const std::lock_guard lock(mutex_);
    end_ = why;
}

void CameraThread::read_fields() {
    pipeline::State state = config::make_state(fields_.settings().config);
    pipeline::RepeatedImages images;
    while (!stops_) {
        auto event = fields_.next();
        if (!event) return;
        auto* const field = std::get_if<Field>(&*event);
        if (!field) continue;
        field->timestamp_s = clock_time_s(field->timestamp_s);
        while (recorded_ && !stops_ && clock_.now_s() < field->timestamp_s) {
            const double left_s = std::min(nap_s, field->timestamp_s - clock_.now_s());
            std::this_thread::sleep_for(std::chrono::duration<double>(left_s));
        }
        for (const WheelPose& reading : new_wheels()) pipeline::note_wheels(state, reading);
        const pipeline::Step& step = pipeline::step(state, *field);
        if (sink_) sink_(*field, step);
        nav::SensorUpdate update = sensor_update_of(step, *field, images);
        const std::lock_guard lock(mutex_);
        arrived_.push_back(std::move(update));
    }
}

/// Converts the time stamp of an image to the clock of the drive: a live image is stamped by the system
/// clock.
double CameraThread::clock_time_s(double timestamp_s) {
    if (!recorded_) return clock_.from_system_s(timestamp_s);
    if (!recording_began_) recording_began_ = clock_.now_s() - timestamp_s;
    return timestamp_s + *recording_began_;
}

}  // namespace flownav::drive
