#include "flownav/testing/reference_base.h"

#include <chrono>

namespace flownav::testing {
namespace {

using namespace nav::base_protocol;

constexpr double patience_s = 0.02;

double steady_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ReferenceBase::ReferenceBase(const ReferenceBaseOptions& options)
    : options_(options), listener_(options.port), vehicle_(options.robot, {}), start_s_(steady_s()) {}

double ReferenceBase::now_s() const {
    return steady_s() - start_s_;
}

void ReferenceBase::serve(const std::function<bool()>& ended) {
    while (!ended()) {
        if (!listener_.wait(patience_s)) continue;
        client_.emplace(listener_.accept());
        lines_ = {};
        sequence_ = 0;
        greeted_ = over_ = false;
        try {
            serve_one(ended);
        } catch (const nav::RobotError&) {
            // It is gone; the next one may come.
        }
        vehicle_.command(now_s(), {});
        client_.reset();
    }
}

void ReferenceBase::serve_one(const std::function<bool()>& ended) {
    double due_s = now_s();
    while (!ended() && !over_) {
        if (client_->wait(std::min(patience_s, std::max(0.0, due_s - now_s())))) {
            lines_.add(client_->receive());
            while (const std::optional<std::string> line = lines_.next()) answer(*line);
            if (lines_.is_overlong()) return;
        }
        watch();
        if (!greeted_ || now_s() < due_s) continue;
        due_s = now_s() + 1.0 / options_.rate_hz;
        vehicle_.advance(now_s());
        client_->send(text(nav::WheelReading{now_s(), vehicle_.pose(), vehicle_.motion()}));
    }
}

void ReferenceBase::answer(const std::string& line) {
    const Line parsed = parse(line);
    if (const auto* hello = std::get_if<Hello>(&parsed)) {
        if (hello->version != version) client_->send(text(Complaint{"this base speaks version 1"}));
        client_->send(text(Hello{version, options_.timeout_ms}));
        greeted_ = true;
    } else if (const auto* drive = std::get_if<Drive>(&parsed)) {
        if (!greeted_ || drive->sequence <= sequence_) return;  // old news
        sequence_ = drive->sequence;
        commanded_s_ = now_s();
        moves_ = true;
        vehicle_.advance(now_s());
        vehicle_.command(now_s(), drive->command);
    } else if (std::holds_alternative<Bye>(parsed)) {
        over_ = true;
    } else if (const auto* malformed = std::get_if<Malformed>(&parsed)) {
        client_->send(text(Complaint{malformed->why}));
    }
}

/// Stops by itself when nobody commands.
void ReferenceBase::watch() {
    if (!moves_ || now_s() - commanded_s_ < options_.timeout_ms / 1000.0) return;
    moves_ = false;
    vehicle_.advance(now_s());
    vehicle_.command(now_s(), {});
    client_->send(text(Stopped{}));
}

}  // namespace flownav::testing
