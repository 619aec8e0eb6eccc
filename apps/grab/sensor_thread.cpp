#include "sensor_thread.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt/serialization/CSerializable.h>

#include <cmath>

#include "flownav/io/flow_obstacle_sensor.h"

namespace flownav {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;
using mrpt::hwdrivers::CGenericSensor;

/// Observations older than this come from a recording; such a source can wait for the disk.
constexpr double live_s = 60.0;

double now_s() {
    return Seconds(Clock::now().time_since_epoch()).count();
}

bool is_recorded(mrpt::Clock::time_point time) {
    return std::abs(mrpt::Clock::toDouble(mrpt::Clock::now()) - mrpt::Clock::toDouble(time)) > live_s;
}

}  // namespace

struct SensorThread::Shared {
    Shared(SensorSetup s, std::shared_ptr<DiskWriter> w) : setup(std::move(s)), writer(std::move(w)) {}

    void run();
    void work();
    void check_end();
    void pass_on();
    bool stopped_within(Clock::time_point time);
    void end(SensorState::Phase how, std::string why);

    const SensorSetup setup;
    const std::shared_ptr<DiskWriter> writer;
    std::atomic<double> last_sign_s{now_s()};
    std::atomic<bool> waits_for_disk{false};

    mutable std::mutex mutex;
    std::condition_variable changed;
    SensorState state;
    bool stop = false;
    bool done = false;
};

void SensorThread::Shared::run() {
    try {
        work();
        end(SensorState::Phase::Ended, "");
    } catch (const EndOfInput&) {
        end(SensorState::Phase::Ended, "");
    } catch (const mrpt::serialization::CExceptionEOF&) {  // CCameraSensor with a rawlog
        end(SensorState::Phase::Ended, "");
    } catch (const std::exception& error) {
        end(SensorState::Phase::Failed, plain_sentence(error.what()));
    }
}

void SensorThread::Shared::work() {
    setup.sensor->initialize();
    last_sign_s = now_s();
    const auto period =
        std::chrono::duration_cast<Clock::duration>(Seconds(1.0 / setup.sensor->getProcessRate()));
    auto due = Clock::now();
    do {
        setup.sensor->doProcess();
        pass_on();
        check_end();
        due = std::max(due + period, Clock::now());
    } while (!stopped_within(due));
}

/// Throws when the sensor has ended, regularly or not.
void SensorThread::Shared::check_end() {
    if (const auto* flow = dynamic_cast<const CFlowObstacleSensor*>(setup.sensor.get());
        flow && flow->ended()) {
        if (flow->error().empty()) throw EndOfInput("");
        throw std::runtime_error(flow->error());
    }
    if (setup.sensor->getState() == CGenericSensor::ssError)
        throw std::runtime_error("the driver reports an error (state ssError)");
}

void SensorThread::Shared::pass_on() {
    for (const auto& [time, object] : setup.sensor->getObservations()) {
        if (!object) continue;
        const auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(object);
        QueuedObject queued{time.time_since_epoch().count(),
                            observation ? observation->sensorLabel : object->GetRuntimeClass()->className,
                            {}};
        mrpt::serialization::ObjectToOctetVector(object.get(), queued.bytes);
        if (is_recorded(time)) {
            waits_for_disk = true;
            writer->put_when_there_is_room(std::move(queued));
            waits_for_disk = false;
        } else {
            writer->put(std::move(queued));
        }
        last_sign_s = now_s();
    }
}

bool SensorThread::Shared::stopped_within(Clock::time_point time) {
    std::unique_lock lock(mutex);
    return changed.wait_until(lock, time, [this] { return stop; });
}

void SensorThread::Shared::end(SensorState::Phase how, std::string why) {
    try {
        pass_on();  // observations from before the failure
    } catch (const std::exception& error) {
        how = SensorState::Phase::Failed;
        if (why.empty()) why = plain_sentence(error.what());
    }
    {
        const std::lock_guard lock(mutex);
        state.phase = how;
        state.message = why;
        done = true;
    }
    changed.notify_all();
}

SensorThread::SensorThread(SensorSetup setup, std::shared_ptr<DiskWriter> writer)
    : shared_(std::make_shared<Shared>(std::move(setup), std::move(writer))),
      thread_([shared = shared_] { shared->run(); }) {}

SensorThread::~SensorThread() {
    stop();
    if (wait_until(Clock::now())) {
        thread_.join();
    } else {
        thread_.detach();
    }
}

void SensorThread::stop() {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->stop = true;
    }
    shared_->changed.notify_all();
}

bool SensorThread::wait_until(Clock::time_point latest) {
    std::unique_lock lock(shared_->mutex);
    return shared_->changed.wait_until(lock, latest, [this] { return shared_->done; });
}

SensorState SensorThread::state() const {
    const std::lock_guard lock(shared_->mutex);
    SensorState state = shared_->state;
    state.silent_s = shared_->waits_for_disk ? 0.0 : now_s() - shared_->last_sign_s;
    return state;
}

const std::string& SensorThread::name() const {
    return shared_->setup.section;
}

}  // namespace flownav
