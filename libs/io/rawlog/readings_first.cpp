#include "flownav/io/readings_first.h"

namespace flownav::io {
namespace {

constexpr double pause_s = 0.3;  // of readings that may still come
constexpr std::size_t waiting_max = 3;

}  // namespace

void ReadingsFirst::push(const SensorEvent& event) {
    if (const auto* field = std::get_if<Field>(&event)) {
        waiting_.push_back(*field);
    } else {
        if (const auto* gyro = std::get_if<GyroRate>(&event)) gyro_s_ = gyro->timestamp_s;
        if (const auto* pose = std::get_if<PoseSample>(&event))
            if (pose->source == PoseSample::Source::Odometry) wheels_s_ = pose->timestamp_s;
        ready_.push_back(event);
    }
    release();
}

void ReadingsFirst::flush() {
    for (Field& field : waiting_) ready_.emplace_back(std::move(field));
    waiting_.clear();
}

std::optional<SensorEvent> ReadingsFirst::pop() {
    if (ready_.empty()) return std::nullopt;
    std::optional<SensorEvent> event = std::move(ready_.front());
    ready_.pop_front();
    return event;
}

bool ReadingsFirst::must_wait(const Field& field) const {
    const auto may_come = [&field](const std::optional<double>& newest_s) {
        return newest_s && *newest_s<field.timestamp_s&& * newest_s> field.timestamp_s - pause_s;
    };
    return may_come(wheels_s_) || may_come(gyro_s_);
}

void ReadingsFirst::release() {
    while (!waiting_.empty() && (waiting_.size() > waiting_max || !must_wait(waiting_.front()))) {
        ready_.emplace_back(std::move(waiting_.front()));
        waiting_.pop_front();
    }
}

}  // namespace flownav::io
