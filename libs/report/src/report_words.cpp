#include "report_words.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace flownav::report {

namespace {

constexpr FigureWords all_figures[] = {
    {"read.objects", "", "whole objects read from the file", ""},
    {"read.images", "", "images of the camera", ""},
    {"read.fields", "", "fields used: one an image, two where frames are woven", "as many as images"},
    {"read.odometry", "", "poses of the odometry, for comparison and for motion.wheels", ""},
    {"read.ground_truth", "", "poses of the ground truth, used for comparison only", ""},
    {"read.gyro", "", "readings of a gyro, for motion.gyro", ""},
    {"read.ignored", "", "observations of other labels or classes", ""},
    {"read.observations", "", "observations of this class and label", ""},
    {"written.trajectory_poses", "", "poses of the flow odometry in trajectory.tum", "one a field"},
    {"written.odometry_poses", "", "poses in odometry.tum", ""},
    {"written.ground_truth_poses", "", "poses in ground_truth.tum", ""},
    {"written.egomotion_rows", "", "rows of egomotion.csv", "one a field"},
    {"written.obstacle_points", "", "points in obstacles.csv", "up to 100 a cycle; 0 on an empty floor"},
    {"written.cycles", "", "finished cycles, each with points, a scan and a part of the map",
     "3 to 6 a second at walking pace"},
    {"written.map_occupied_cells", "", "occupied cells of map.pgm", ""},
    {"written.map_free_cells", "", "cells of map.pgm that are floor", ""},
    {"written.result_rawlog", "", "observations of this label in result.rawlog", ""},
    {"drive.start_s", "s", "time of the first field, since 1970", ""},
    {"drive.duration_s", "s", "from the first field to the last", ""},
    {"drive.path_m", "m", "length of the way by flow odometry", ""},
    {"drive.end_x_m", "m", "end of the way, ahead of the start", ""},
    {"drive.end_y_m", "m", "end of the way, left of the start", ""},
    {"drive.end_heading_deg", "deg", "direction at the end, > 0: turned left", ""},
    {"drive.carried_s", "s", "during which turn and speed were not both measured",
     "below 2 % of the duration"},
    {"drive.carried_longest_s", "s", "the longest stretch of it", "below motion.carry_max_s"},
    {"drive.carried_sigma_m", "m", "deviation of the end position by carrying the pose over", "0"},
    {"motion.turn", "", "fields whose turn came from this source", "flow: all but the first"},
    {"motion.way", "", "fields whose travel came from this source", "flow: all but the first"},
    {"motion.wheels_way", "", "travel by the wheels against the flow", "agrees, or no_readings"},
    {"motion.wheels_way_ratio", "", "travel by the wheels over that by the flow, at the end", "0.95 to 1.05"},
    {"motion.wheels_way_contradicted_s", "s", "during which they contradicted each other", "0"},
    {"motion.wheels_way_not_in_time_s", "s", "during which readings were 1 s or more from the images", "0"},
    {"motion.wheels_turn", "", "turn by the wheels against the flow", "agrees, or no_readings"},
    {"motion.wheels_turn_ratio", "", "turn by the wheels over that by the flow, at the end", "0.95 to 1.05"},
    {"motion.wheels_turn_contradicted_s", "s", "during which they contradicted each other", "0"},
    {"motion.wheels_turn_not_in_time_s", "s", "during which readings were 1 s or more from the images", "0"},
    {"motion.gyro", "", "turn by the gyro against the flow", "agrees, or no_readings"},
    {"motion.gyro_ratio", "", "turn by the gyro over that by the flow, at the end", "0.95 to 1.05"},
    {"motion.gyro_contradicted_s", "s", "during which they contradicted each other", "0"},
    {"motion.gyro_not_in_time_s", "s", "during which readings were 1 s or more from the images", "0"},
    {"motion.gyro_bias_degps", "deg/s", "of the gyro, learnt at standstill and by the flow", "within 2"},
    {"contacts.scans", "", "contact scans, those behind a closed gate included",
     "up to one a cycle; fewer when the robot drives slowly"},
    {"contacts.rows", "", "rows of contacts.csv: strips of the scanned cycles", ""},
    {"contacts.scanned_percent", "%", "finished cycles that were scanned for contacts",
     "over 90; less when the robot drives slowly, since a scan needs some travel"},
    {"contacts.by_gate.open", "", "scans that were made", "nearly all"},
    {"contacts.by_gate.off", "", "scans left out: switched off", "0"},
    {"contacts.by_gate.no_travel", "", "scans left out: the travel is not known, or too short", "few"},
    {"contacts.by_gate.poor_floor", "", "scans left out: too little of the near floor moves as a floor does",
     "few; many: a mirror-like floor or a wrong camera pose"},
    {"contacts.free_strips", "", "strips whose floor was confirmed, mean in a scanned cycle", ""},
    {"contacts.contacts", "", "strips that end at an obstacle, mean in a scanned cycle", ""},
    {"contacts.unknown_strips", "", "strips without evidence, mean in a scanned cycle",
     "few on a textured floor"},
    {"contacts.decided_2m_percent", "%",
     "strips in view with an obstacle within 2 m, or with floor confirmed up to there",
     "over 55 on carpet; 5 on a floor with hardly any texture"},
    {"contacts.by_cause.blocks", "", "contacts that only blocks told", ""},
    {"contacts.by_cause.votes", "", "contacts by pixels that do not move as the floor does", ""},
    {"contacts.by_cause.wall", "", "contacts of surfaces without edges", ""},
    {"contacts.by_cause.drop", "", "contacts where the floor ends", "0 on one level"},
    {"contacts.floor_fit", "", "share of the near floor's pixels that fit, mean of the scanned cycles",
     "over 0.45"},
    {"contacts.vignetting", "", "learnt fall-off of brightness towards the corners of the image", "0 to 0.6"},
    {"bad_fields.no_picture", "", "fields that are black, saturated or constant", "0"},
    {"bad_fields.wrong_size", "", "fields whose image is not as large as their camera says", "0"},
    {"bad_fields.bad_camera", "", "fields whose camera has a number that cannot be used", "0"},
    {"bad_fields.time_not_rising", "", "fields that are not later than the one before", "0"},
    {"errors.fields_compared", "", "fields inside the time of the other track", "all fields"},
    {"errors.omega_rms_degps", "deg/s", "turn rate, root mean square error per field",
     "0.02 to 0.15 on a textured floor"},
    {"errors.omega_cycle_rms_degps", "deg/s", "turn rate, root mean square of the mean error over a cycle",
     "0.005 to 0.07"},
    {"errors.v_bias_percent", "%", "forward speed, mean error of the cycles that measured it",
     "within 0.3 where height and pitch are right; half a degree of pitch makes 2"},
    {"errors.v_sd_percent", "%", "forward speed, standard deviation of that error", "0.1 to 0.8"},
    {"errors.t_measured_percent", "%", "finished cycles whose forward speed was measured",
     "over 90; less: too little texture near the robot"},
    {"errors.end_position_percent", "%", "distance between the end positions, of the path's length",
     "0.1 to 1"},
    {"errors.heading_end_deg", "deg", "difference of the end headings, > 0: flow odometry too far left",
     "within 0.2"},
    {"errors.path_m", "m", "length of the path compared with", ""},
    {"camera_check.verdict", "", "whether the camera's pose agrees with how the floor moves", "consistent"},
    {"camera_check.pairs", "", "cycles that showed enough floor to tell", "16 or more"},
    {"camera_check.agreeing_share", "", "share of the vectors of the near floor that agree with a plane",
     "over 0.65"},
    {"camera_check.pitch_error_deg", "deg", "what would have to be added to the pitch", "within 1"},
    {"camera_check.roll_error_deg", "deg", "what would have to be added to the roll", "within 1"},
    {"camera_check.yaw_error_deg", "deg", "what would have to be added to the yaw", "within 1"},
    {"camera_check.pitch_sigma_deg", "deg", "uncertainty of that pitch", "below 0.3"},
    {"camera_check.roll_sigma_deg", "deg", "uncertainty of that roll", "below 0.3"},
    {"camera_check.yaw_sigma_deg", "deg", "uncertainty of that yaw", "below 0.3"},
    {"camera_check.odometry_ratio", "", "distances by odometry over those by flow",
     "0.8 to 1.25; else the height is wrong"},
    {"camera_check.odometry_ratio_sigma", "", "uncertainty of that ratio", "below 0.02"},
};

struct ReasonWords {
    const char* reason;
    const char* words;
};

constexpr ReasonWords all_reasons[] = {
    {"time_invalid", "has no valid time stamp"},
    {"time_repeated", "has the same time stamp as the one before"},
    {"time_backwards", "is older than the one before it"},
    {"time_out_of_range", "has a time stamp before 1970 or after 2100"},
    {"time_ahead", "has a time stamp far from those before and after it"},
    {"time_too_close", "has a time stamp that nearly equals that of a neighbour"},
    {"time_uneven", "has a time stamp off the beat of the others"},
    {"time_irregular", "came far sooner after the one before than usual"},
    {"clock_set_back", "the clock was set back here; the times behind it were shifted"},
    {"clock_jump", "a pause, or the clock was set ahead here"},
    {"not_finite", "holds a number that is none"},
    {"image_missing", "the file with the picture is not where the recording says"},
    {"image_unreadable", "the file with the picture cannot be read as one"},
    {"image_empty", "holds no picture"},
    {"image_not_8bit", "pixels of more than 8 bits are not supported"},
    {"calibration_of_another_size", "the recorded image size is another, but the calibration fits this one"},
    {"calibration_scaled", "the recorded calibration was for another image size; scaled"},
    {"pose_x_forward", "the recorded pose had the axes of the robot; converted to optical axes"},
    {"principal_point_off_centre", "the principal point is far from the middle of the image"},
    {"image_size_changed", "the image size changed on the way; sensing began anew"},
    {"calibration_changed", "the calibration or the camera's pose changed on the way; sensing began anew"},
};

}  // namespace

const FigureWords* figure_words(const std::string& key) {
    const auto same = [&key](const FigureWords& words) { return key == words.key; };
    const auto* found = std::find_if(std::begin(all_figures), std::end(all_figures), same);
    return found == std::end(all_figures) ? nullptr : found;
}

std::string reason_words(const std::string& reason) {
    std::string rest = reason;
    std::string subject = "image: ";
    for (const auto& [prefix, name] : {std::pair{"odometry_", "pose of the odometry: "},
                                       std::pair{"ground_truth_", "pose of the ground truth: "},
                                       std::pair{"gyro_", "reading of the gyro: "}}) {
        if (rest.rfind(prefix, 0) != 0) continue;
        rest.erase(0, std::string(prefix).size());
        subject = name;
    }
    const auto same = [&rest](const ReasonWords& words) { return rest == words.reason; };
    const auto* found = std::find_if(std::begin(all_reasons), std::end(all_reasons), same);
    return found == std::end(all_reasons) ? reason : subject + found->words;
}

}  // namespace flownav::report
