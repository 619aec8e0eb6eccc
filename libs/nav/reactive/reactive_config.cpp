#include "reactive_config.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "flownav/math/units.h"
#include "flownav/nav/motion_model.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

constexpr double table_cell_m = 0.03;  // coarser ones close passages of a robot's width
constexpr int paths = 81;
// Paths that turn to a heading at once lead a robot that follows something away from it again and again.
constexpr double circles_priority = 1.0;
constexpr double headings_priority = 0.5;

Vector2d outward(const Vector2d& from, const Vector2d& to) {
    const Vector2d along = (to - from).normalized();
    return {along.y(), -along.x()};
}

constexpr const char* fixed_part = R"(
[CAbstractNavigator]
dist_to_target_for_sending_event = 0
alarm_seems_not_approaching_target_timeout = 1e9
dist_check_target_is_blocked = 0
hysteresis_check_target_is_blocked = 3

[CWaypointsNavigator]
max_distance_to_allow_skip_waypoint = -1
min_timesteps_confirm_skip_waypoints = 1
waypoint_angle_tolerance = 5
multitarget_look_ahead = 0

[CHolonomicFullEval]
factorWeights = [0.25, 0.1, 1, 0.05, 0.5, 1, 1]
factorNormalizeOrNot = [0, 0, 0, 0, 1, 1, 0]
TOO_CLOSE_OBSTACLE = 0.02
TARGET_SLOW_APPROACHING_DISTANCE = 0.1
OBSTACLE_SLOW_DOWN_DISTANCE = 0.15
HYSTERESIS_SECTOR_COUNT = 5
LOG_SCORE_MATRIX = false
clearance_threshold_ratio = 0.05
gap_width_ratio_threshold = 0.1
PHASE_COUNT = 1
PHASE1_FACTORS = [0 1 2 3 4 5 6]
PHASE1_THRESHOLD = 0.5

[CMultiObjectiveMotionOptimizerBase]
score1_name = target_distance
score1_formula = \
    var rest := max(0, target_d_norm - move_cur_d); \
    if (collision_free_distance > rest, 1 / (1 + rest^2), 0)
score2_name = free_distance
score2_formula = \
    var rest := max(0, target_d_norm - move_cur_d); \
    if (collision_free_distance > (rest + 0.05), 1.0, collision_free_distance)
score3_name = nearness
score3_formula = 1 / (1 + dist_eucl_min^2)
score4_name = hysteresis_score
score4_formula = hysteresis
score5_name = path_near_target
score5_formula = \
    var dif := abs(target_k - move_k); \
    if (dif > (num_paths / 2)) { dif := num_paths - dif; }; \
    exp(-abs(dif / (num_paths / 10.0)))
score6_name = priority
score6_formula = ptg_priority
scores_to_normalize =

[CMultiObjMotionOpt_Scalarization]
scalar_score_formula = priority * (0.3 * target_distance + 0.5 * free_distance + 8.0 * nearness + \
    0.1 * hysteresis_score + 0.2 * path_near_target)
)";

void write_ptg(std::ostream& out, int number, const std::string& type, const RobotModel& robot,
               double priority) {
    const std::string name = "PTG" + std::to_string(number) + "_";
    out << name << "Type = " << type << '\n'
        << name << "resolution = " << table_cell_m << '\n'
        << name << "refDistance = " << reactive_range_m << '\n'
        << name << "num_paths = " << paths << '\n'
        << name << "v_max_mps = " << robot.v_max_mps << '\n'
        << name << "w_max_dps = " << deg(2.0 * robot.v_max_mps) << '\n'
        << name << "K = 1.0\n"
        << name << "cte_a0v_deg = 57\n"
        << name << "cte_a0w_deg = 57\n"
        << name << "score_priority = " << priority << '\n';
}

void write_shape(std::ostream& out, const Polygon& footprint_m) {
    out << "RobotModel_shape2D_xs =";
    for (const Vector2d& corner : footprint_m) out << ' ' << corner.x();
    out << "\nRobotModel_shape2D_ys =";
    for (const Vector2d& corner : footprint_m) out << ' ' << corner.y();
    out << "\nRobotModel_circular_shape_radius = " << circumscribed_radius_m(footprint_m) << '\n';
}

}  // namespace

Polygon inflated(const Polygon& polygon, double by_m) {
    Polygon wider;
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vector2d before = outward(polygon[(i + n - 1) % n], polygon[i]);
        const Vector2d after = outward(polygon[i], polygon[(i + 1) % n]);
        // The two moved edges meet here; nearly folded back corners do not shoot out.
        wider.push_back(polygon[i] + by_m * (before + after) / std::max(0.2, 1.0 + before.dot(after)));
    }
    return wider;
}

std::string reactive_config(const NavigatorOptions& options) {
    const RobotModel& robot = options.robot;
    std::ostringstream out;
    out.imbue(std::locale::classic());
    const double slow_m = stopping_distance_m(robot, robot.v_max_mps) + 0.2;
    out << fixed_part << "\n[CAbstractPTGBasedReactive]\n"
        << "robotMax_V_mps = " << robot.v_max_mps << '\n'
        << "robotMax_W_degps = " << deg(robot.omega_max_radps) << '\n'
        << "holonomic_method = CHolonomicFullEval\n"
        << "motion_decider_method = CMultiObjMotionOpt_Scalarization\n"
        << "ref_distance = " << reactive_range_m << '\n'
        << "secure_distance_start = 0.02\n"
        << "secure_distance_end = " << std::min(0.5, slow_m / reactive_range_m) << '\n'
        << "use_delays_model = false\n"
        << "enable_obstacle_filtering = false\n"
        << "evaluate_clearance = false\n"
        << "\n[CReactiveNavigationSystem]\n"
        << "min_obstacles_height = 0\nmax_obstacles_height = " << robot.height_m << '\n'
        << "PTG_COUNT = 2\n";
    write_ptg(out, 0, "CPTG_DiffDrive_C", robot, circles_priority);
    write_ptg(out, 1, "CPTG_DiffDrive_alpha", robot, headings_priority);
    write_shape(out, inflated(robot.footprint_m, reactive_margin_m));
    return out.str();
}

}  // namespace flownav::nav
