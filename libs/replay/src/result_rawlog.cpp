#include "flownav/replay/result_rawlog.h"

#include "flownav/io/observations.h"

namespace flownav {

void ResultRawlog::write(const pipeline::Step& step) {
    write_object(*odometry_observation(step));
    if (!step.end_of_cycle) return;
    write_object(*scan_observation(step, range_max_m_));
    write_object(*points_observation(step));
}

void ResultRawlog::write_odometry(const PoseSample& sample) {
    write_object(*odometry_observation(sample));
}

void ResultRawlog::write_image(const Field& field, const std::string& label) {
    write_object(*image_observation(field, label));
}

void ResultRawlog::write_object(const mrpt::obs::CObservation& observation) {
    flownav::write_object(file_, observation);
    ++counts_[observation.sensorLabel];
}

}  // namespace flownav
