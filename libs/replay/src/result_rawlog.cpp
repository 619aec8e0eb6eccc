#include "flownav/replay/result_rawlog.h"

#include "flownav/io/observations.h"

namespace flownav::replay {

void ResultRawlog::write(const pipeline::Step& step) {
    write_object(*io::odometry_observation(step));
    write_object(*io::pose_observation(step));
    if (!step.end_of_cycle) return;
    write_object(*io::scan_observation(step, range_max_m_));
    write_object(*io::points_observation(step));
}

void ResultRawlog::write_odometry(const io::PoseSample& sample) {
    write_object(*io::odometry_observation(sample));
}

void ResultRawlog::write_image(const Field& field, const std::string& label) {
    write_object(*io::image_observation(field, label));
}

void ResultRawlog::write_object(const mrpt::obs::CObservation& observation) {
    io::write_object(file_, observation);
    ++counts_[observation.sensorLabel];
}

}  // namespace flownav::replay
