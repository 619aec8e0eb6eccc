#include "flownav/sim/drive_script.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <vector>

#include "flownav/math/units.h"
#include "flownav/sim/vehicle.h"

namespace flownav::sim {
namespace {

struct Step {
    std::string text;
    std::string word;
    std::vector<double> numbers;
};

[[noreturn]] void refuse(const std::string& step, const std::string& what) {
    throw PathError("\"" + step + "\" in the script: " + what);
}

Step parse(const std::string& text) {
    Step step;
    std::istringstream words(text);
    words >> step.word;
    step.text = step.word;
    for (std::string word; words >> word;) {
        step.text += ' ' + word;
        double value = 0.0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value) || value <= 0.0)
            refuse(step.text, word + " is not a number above 0");
        step.numbers.push_back(value);
    }
    return step;
}

std::vector<Step> parse_all(std::string script) {
    std::replace(script.begin(), script.end(), '\n', ';');
    std::vector<Step> steps;
    std::istringstream parts(script);
    for (std::string part; std::getline(parts, part, ';');)
        if (part.find_first_not_of(" \t\r") != std::string::npos) steps.push_back(parse(part));
    return steps;
}

/// A command that holds for a while.
struct Hold {
    MotionCommand command;
    double duration_s = 0.0;
};

constexpr double step_s = 0.001;
constexpr double longest_s = 3600.0;

double whole_steps(double duration_s) {
    return std::max(1.0, std::round(duration_s / step_s)) * step_s;
}

/// Turns steps into commands for a vehicle that starts and stops at the limits of its model.
class Driver {
  public:
    explicit Driver(const RobotModel& robot)
        : robot_(robot), v_mps_(robot.v_max_mps), omega_radps_(robot.omega_max_radps / 2) {}

    void add(const Step& step) {
        const std::size_t most = step.word == "left" || step.word == "right" ? 2 : 1;
        const bool known = step.word == "forward" || step.word == "back" || most == 2 ||
                           step.word == "wait" || step.word == "speed" || step.word == "turn";
        if (!known) refuse(step.text, "a step is forward, back, left, right, wait, speed or turn");
        if (step.numbers.empty() || step.numbers.size() > most) {
            refuse(step.text,
                   most == 2 ? "needs an angle in degrees, and at most a radius" : "needs one number");
        }
        take(step, step.numbers.front());
    }

    std::vector<Hold> holds() {
        stop();
        return std::move(holds_);
    }

  private:
    void take(const Step& step, double value) {
        if (step.word == "forward") return curve(step, value, 0.0);
        if (step.word == "back") return back(value);
        if (step.word == "wait") return wait(value);
        if (step.word == "speed") {
            if (value > robot_.v_max_mps)
                refuse(step.text, "the robot's fastest is " + text(robot_.v_max_mps) + " m/s");
            stop();
            v_mps_ = value;
            return;
        }
        if (step.word == "turn") {
            omega_radps_ = value * degree_rad;
            if (omega_radps_ > robot_.omega_max_radps) {
                refuse(step.text,
                       "the robot's fastest is " + text(robot_.omega_max_radps / degree_rad) + " deg/s");
            }
            return;
        }
        const double angle_rad = (step.word == "left" ? value : -value) * degree_rad;
        if (step.numbers.size() == 2) return curve(step, std::abs(angle_rad) * step.numbers[1], angle_rad);
        turn(angle_rad);
    }

    static std::string text(double value) {
        std::ostringstream out;
        out << value;
        return out.str();
    }

    /// A turn speeds up and slows down alike, so that omega times duration is its angle.
    void turn(double angle_rad) {
        stop();
        const double fastest_radps =
            std::min(omega_radps_, std::sqrt(std::abs(angle_rad) * robot_.alpha_radps2));
        // Never shorter than it takes to get to that speed.
        const double duration_s = std::ceil(std::abs(angle_rad) / fastest_radps / step_s) * step_s;
        holds_.push_back({{0.0, angle_rad / duration_s}, duration_s});
        wait(fastest_radps / robot_.alpha_radps2);
    }

    void curve(const Step& step, double length_m, double angle_rad) {
        const double duration_s = whole_steps(length_m / v_mps_);
        const double omega_radps = angle_rad / duration_s;
        if (std::abs(omega_radps) > robot_.omega_max_radps) refuse(step.text, "too narrow at this speed");
        if (std::abs(omega_radps) > duration_s * robot_.alpha_radps2) refuse(step.text, "too short a curve");
        moving_.push_back({{v_mps_, omega_radps}, duration_s});
    }

    void back(double length_m) {
        stop();
        const double v_mps = v_mps_;
        v_mps_ = std::min(v_mps, robot_.v_back_mps);
        moving_.push_back({{-v_mps_, 0.0}, whole_steps(length_m / v_mps_)});
        stop();
        v_mps_ = v_mps;
    }

    void wait(double duration_s) {
        stop();
        holds_.push_back({{}, whole_steps(duration_s)});
    }

    /// Ends what is driven without a stop. The way of speeding up belongs to a straight piece at the
    /// beginning, that of braking to one at the end; a curve there gets a straight piece of its own before or
    /// after it.
    void stop() {
        if (moving_.empty()) return;
        const double up_s = v_mps_ / robot_.accel_mps2;
        const double down_s = v_mps_ / robot_.brake_mps2;
        Hold& first = moving_.front();
        Hold& last = moving_.back();
        const bool straight = moving_.size() == 1 && first.command.omega_radps == 0.0;
        if (straight && first.duration_s < (up_s + down_s) / 2) {
            // Too short for the full speed: the way grows with the square of the fastest speed.
            const double share = std::sqrt(first.duration_s / ((up_s + down_s) / 2));
            first = {{first.command.v_mps * share, 0.0}, whole_steps(up_s * share)};
        } else {
            if (first.command.omega_radps == 0.0) {
                first.duration_s += whole_steps(up_s / 2);
            } else {
                holds_.push_back({{first.command.v_mps, 0.0}, whole_steps(up_s)});
            }
            if (last.command.omega_radps == 0.0) last.duration_s -= whole_steps(down_s / 2);
        }
        for (Hold& move : moving_) move.duration_s = std::max(move.duration_s, 0.0);
        holds_.insert(holds_.end(), moving_.begin(), moving_.end());
        moving_.clear();
        holds_.push_back({{}, whole_steps(down_s)});
    }

    RobotModel robot_;
    double v_mps_;
    double omega_radps_;
    std::vector<Hold> moving_;
    std::vector<Hold> holds_;
};

}  // namespace

TimedPath drive_script(const std::string& script, const RobotModel& robot, const Pose2& start) {
    const std::vector<Step> steps = parse_all(script);
    if (steps.empty()) throw PathError("the script is empty");
    Driver driver(robot);
    for (const Step& step : steps) driver.add(step);

    RobotModel at_once = robot;
    at_once.delay_s = 0.0;
    Vehicle vehicle(at_once, start);
    double begin_s = 0.0;
    std::vector<PathPoint> points{{0.0, start}};
    const std::vector<Hold> holds = driver.holds();
    double lasts_s = 0.0;
    for (const Hold& hold : holds) lasts_s += hold.duration_s;
    if (!(lasts_s <= longest_s)) throw PathError("the script lasts longer than an hour");
    for (const Hold& hold : holds) {
        vehicle.command(begin_s, hold.command);
        begin_s += hold.duration_s;
        while (points.back().time_s < begin_s - step_s / 2) {
            const double time_s = static_cast<double>(points.size()) * step_s;
            vehicle.advance(time_s);
            points.push_back({time_s, vehicle.pose()});
        }
    }
    return TimedPath(std::move(points));
}

}  // namespace flownav::sim
