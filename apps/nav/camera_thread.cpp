#include "camera_thread.h"

#include <utility>
#include <variant>

#include "flownav/pipeline/pipeline.h"
#include "flownav/pipeline/sensor_report.h"
#include "flownav/sensor/make_state.h"

namespace flownav {

nav::Sensed sensed_of(const pipeline::Step& step, const Field& field, pipeline::RepeatedImages& images,
                      double epoch_s) {
    nav::Sensed sensed;
    sensed.report = pipeline::sensor_report(step, field.camera);
    sensed.report.repeated = images.is_repeated(field.image);
    sensed.report.timestamp_s -= epoch_s;
    if (step.status == FieldStatus::Ok) sensed.T_start_robot = step.T_start_robot;
    if (step.end_of_cycle) {
        sensed.points = step.obstacles;
        sensed.ground = step.ground;
    }
    return sensed;
}

CameraThread::CameraThread(const ProducerSettings& settings)
    : fields_(settings), thread_([this] { run(); }) {}

CameraThread::~CameraThread() {
    stops_ = true;
    thread_.join();
}

std::vector<nav::Sensed> CameraThread::arrived() {
    const std::lock_guard lock(mutex_);
    return std::exchange(arrived_, {});
}

std::string CameraThread::end() {
    const std::lock_guard lock(mutex_);
    return end_;
}

void CameraThread::run() {
    pipeline::State state = make_state(fields_.settings().config);
    pipeline::RepeatedImages images;
    while (!stops_) {
        const auto event = fields_.next();
        if (!event) break;
        const auto* field = std::get_if<Field>(&*event);
        if (!field) continue;
        nav::Sensed sensed = sensed_of(pipeline::step(state, *field), *field, images);
        const std::lock_guard lock(mutex_);
        arrived_.push_back(std::move(sensed));
    }
    const std::lock_guard lock(mutex_);
    end_ = fields_.error().empty() ? "the camera's source has ended" : fields_.error();
}

}  // namespace flownav
