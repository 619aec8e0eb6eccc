#include "grabber.h"

#include <algorithm>
#include <sstream>

namespace flownav {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr auto patience = std::chrono::seconds(3);  // limit for drivers to end

std::string text_of(double seconds) {
    std::ostringstream text;
    text.precision(3);
    text << seconds;
    return text.str();
}

}  // namespace

Grabber::Grabber(const GrabSetup& setup, const GrabOptions& options)
    : options_(options), writer_(std::make_shared<DiskWriter>(options.recording, options.queue_bytes)) {
    for (const SensorSetup& sensor : setup.sensors) {
        if (!sensors_.empty()) std::this_thread::sleep_for(Seconds(setup.time_between_launches_s));
        sensors_.push_back(std::make_unique<SensorThread>(sensor, writer_));
    }
}

double Grabber::elapsed_s() const {
    return Seconds(Clock::now() - start_).count();
}

std::string Grabber::failure_of(const SensorThread& sensor) const {
    const SensorState state = sensor.state();
    if (state.phase == SensorState::Phase::Failed) return "sensor " + sensor.name() + ": " + state.message;
    const bool silent = options_.silence_s > 0 && state.silent_s > options_.silence_s;
    if (state.phase != SensorState::Phase::Running || !silent) return "";
    return "sensor " + sensor.name() + ": no observation for " + text_of(options_.silence_s) +
           " s; where that is normal, use --silence";
}

bool Grabber::done() const {
    if (options_.duration_s > 0 && elapsed_s() >= options_.duration_s) return true;
    if (!writer_->failure().empty()) return true;
    const auto failed = [this](const auto& sensor) { return !failure_of(*sensor).empty(); };
    if (std::any_of(sensors_.begin(), sensors_.end(), failed)) return true;
    return std::all_of(sensors_.begin(), sensors_.end(),
                       [](const auto& sensor) { return sensor->state().phase == SensorState::Phase::Ended; });
}

GrabResult Grabber::finish() {
    GrabResult result;
    const auto report = [&result](GrabStatus status, const std::string& message) {
        result.status = result.status == GrabStatus::Fine ? status : result.status;
        result.messages.push_back(message);
    };
    std::vector<std::string> failures;
    for (const auto& sensor : sensors_) failures.push_back(failure_of(*sensor));
    for (const auto& sensor : sensors_) sensor->stop();
    const auto latest = Clock::now() + patience;
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
        if (!sensors_[i]->wait_until(latest)) {
            result.hanging = true;
            if (failures[i].empty()) failures[i] = "sensor " + sensors_[i]->name() + ": does not end";
        } else if (failures[i].empty()) {
            failures[i] = failure_of(*sensors_[i]);
        }
    }
    writer_->finish();
    const WriterCounts counts = writer_->counts();
    if (!writer_->failure().empty()) {
        report(GrabStatus::Output, writer_->failure() + "; " + std::to_string(counts.lost) +
                                       " observations were lost, all before them are in the recording");
    }
    for (const std::string& failure : failures)
        if (!failure.empty()) report(GrabStatus::Sensor, failure);
    for (const auto& [label, count] : counts.dropped) {
        report(GrabStatus::Dropped, "the disk was too slow: " + std::to_string(count) + " observations of " +
                                        label + " were dropped");
    }
    return result;
}

}  // namespace flownav
