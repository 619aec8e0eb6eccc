#include "flownav/io/flow_obstacle_sensor.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationComment.h>

#include <iostream>
#include <utility>
#include <variant>

#include "flownav/config/make_state.h"
#include "flownav/io/note_reading.h"
#include "flownav/io/observations.h"
#include "flownav/io/rawlog_reader.h"

IMPLEMENTS_GENERIC_SENSOR(CFlowObstacleSensor, flownav)

namespace flownav {

CFlowObstacleSensor::CFlowObstacleSensor() : COutputLogger("CFlowObstacleSensor") {
    m_sensorLabel = "FLOW";
}

CFlowObstacleSensor::~CFlowObstacleSensor() = default;

void CFlowObstacleSensor::loadConfig_sensorSpecific(const mrpt::config::CConfigFileBase& ini,
                                                    const std::string& section) {
    try {
        settings_ = io::read_producer_settings(ini, section);
    } catch (const config::ConfigError&) {
        m_state = ssError;
        throw;
    }
}

void CFlowObstacleSensor::initialize() {
    try {
        fields_.emplace(settings_);
    } catch (const std::runtime_error& error) {  // InputError or ConfigError
        m_state = ssError;
        MRPT_LOG_ERROR_STREAM(error.what());
        throw;
    }
    state_.emplace(config::make_state(settings_.config));
    m_state = ssWorking;
}

void CFlowObstacleSensor::doProcess() {
    if (!fields_) throw std::logic_error("CFlowObstacleSensor: doProcess() before initialize()");
    if (!end_text_.empty()) return wait_and_throw();
    Batch batch;
    while (auto event = next_due()) {
        if (const auto* field = std::get_if<Field>(&*event)) {
            evaluate(*field, batch);
            break;
        }
        io::note_reading(*state_, *event);
        const auto* sample = std::get_if<io::PoseSample>(&*event);
        if (sample == nullptr) continue;
        latest_s_ = std::max(latest_s_, sample->timestamp_s);
        const bool odometry = sample->source == io::PoseSample::Source::Odometry;
        if (odometry && settings_.use_odometry) batch.push_back(io::odometry_observation(*sample));
    }
    if (ended()) end(batch);
    if (!batch.empty()) appendObservations(batch);
}

/// Returns the next event; empty at the end, or when the next field is not due yet.
std::optional<io::SensorEvent> CFlowObstacleSensor::next_due() {
    auto event = early_ ? std::exchange(early_, std::nullopt) : fields_->next();
    const auto* field = event ? std::get_if<Field>(&*event) : nullptr;
    if (field == nullptr || !settings_.paced) return event;
    const double now_s = mrpt::Clock::nowDouble();
    if (!clock_offset_s_) clock_offset_s_ = now_s - field->timestamp_s;
    if (now_s >= field->timestamp_s + *clock_offset_s_) return event;
    early_ = std::move(event);
    return std::nullopt;
}

void CFlowObstacleSensor::evaluate(const Field& field, Batch& batch) {
    const pipeline::Step& step = pipeline::step(*state_, field);
    latest_s_ = std::max(latest_s_, field.timestamp_s);
    if (settings_.publish_image) {
        batch.push_back(io::image_observation(field, settings_.config.camera.camera_label));
    }
    add(batch, io::odometry_observation(step), "_ODOMETRY");
    add(batch, io::pose_observation(step), "_POSE");
    if (!step.end_of_cycle) return;
    add(batch, io::scan_observation(step, settings_.config.pipeline.obstacles.range_max_m), "_SCAN");
    add(batch, io::points_observation(step), "_POINTS");
}

void CFlowObstacleSensor::add(Batch& batch, const mrpt::obs::CObservation::Ptr& observation,
                              const char* suffix) const {
    observation->sensorLabel = settings_.label_prefix + suffix;
    batch.push_back(observation);
}

void CFlowObstacleSensor::end(Batch& batch) {
    for (const std::string& note : fields_->notes()) MRPT_LOG_WARN_STREAM(note);
    const std::string fields = std::to_string(fields_->counts().fields) + " fields";
    if (error().empty()) {
        end_text_ = settings_.source + " was read to its end: " + fields;
        MRPT_LOG_INFO_STREAM(end_text_);
    } else {
        m_state = ssError;
        end_text_ = "the input failed after " + fields + ": " + error();
        MRPT_LOG_ERROR_STREAM(end_text_);
    }
    auto comment = mrpt::obs::CObservationComment::Create();
    comment->timestamp = mrpt::Clock::fromDouble(latest_s_);
    comment->text = end_text_;
    add(batch, comment, "_END");
}

void CFlowObstacleSensor::wait_and_throw() {
    calls_since_end_ += 1.0;
    if (calls_since_end_ < settings_.end_wait_s * m_process_rate) return;
    m_state = ssError;
    if (!error().empty()) throw io::InputError(end_text_);
    throw EndOfInput(end_text_);
}

}  // namespace flownav
