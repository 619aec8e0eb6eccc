#pragma once
#include <string>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/evaluation/field_row.h"
#include "flownav/evaluation/pose_track.h"
#include "flownav/io/sensor_event.h"

namespace flownav::evaluation {

/// One sentence about data of a recording that were left out, put right, or contradict each other.
struct Finding {
    std::string reason;       ///< stable name, listed in share/doc/odd_recordings.md
    std::string sentence;     ///< what, how many, and what to do
    bool loses_data = false;  ///< data that the results needed were lost
};

/// Judges what was left out or put right while reading: every reason above 2 % of the images, or of the
/// readings of its sensor, and every clock that was set and calibration that was converted; odometry and
/// ground truth that were ignored for their label.
std::vector<Finding> input_findings(const io::InputCounts& read, const config::InputConfig& input);

/// Judges what became of the fields: too far apart in time, bad or lost, and a view that pitches as no
/// robot's does.
std::vector<Finding> field_findings(const std::vector<FieldRow>& rows, const FieldFaultCounts& faults,
                                    const pipeline::RateParams& rate);

/// Judges the flow of a drive against poses of another source, called `name` in the sentences ("the
/// odometry"): times, length of the way, sign and size of turns, sideways motion.
std::vector<Finding> track_findings(const std::vector<FieldRow>& rows, const PoseTrack& track,
                                    const std::string& name);

}  // namespace flownav::evaluation
