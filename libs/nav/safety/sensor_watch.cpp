#include "flownav/nav/sensor_watch.h"

#include <numeric>

#include "sentence.h"

namespace flownav::nav {
namespace {

int sum(const std::array<int, SensorReport::sectors>& counts) {
    return std::accumulate(counts.begin(), counts.end(), 0);
}

/// True when the flow or other sensors tell the motion, and contact scans see things without texture.
bool is_told(const SensorReport& report) {
    return report.scans && report.sees_edges && report.carried_s == 0.0 &&
           report.status != FieldStatus::BadField && report.status != FieldStatus::Waiting;
}

}  // namespace

void SensorWatch::sensed(const SensorReport& report) {
    if (newest_ && report.timestamp_s <= newest_->timestamp_s) return;  // no news
    if (!newest_) last_ok_s_ = last_seen_s_ = report.timestamp_s;
    newest_ = report;
    arrived_ = true;
    if (report.status == FieldStatus::Lost) last_seen_s_ = report.timestamp_s;
    const bool told = is_told(report);
    const bool is_measured = report.status == FieldStatus::Ok;
    if (told || (is_measured && sum(report.confident) >= params_.confident_min))
        last_ok_s_ = last_seen_s_ = report.timestamp_s;
    if (told || is_measured) note_sectors(report);
}

void SensorWatch::note_sectors(const SensorReport& report) {
    for (std::size_t i = 0; i < report.blocks.size(); ++i) {
        const bool few_blocks = report.confident[i] < params_.sector_share * report.blocks[i];
        // Something without texture is in view when light comes and scans look for such things. A cover is
        // black, whatever the last scan saw.
        const bool blind = few_blocks && (report.unlit[i] || !report.scans);
        if (!blind) blind_since_s_[i].reset();
        if (blind && !blind_since_s_[i]) blind_since_s_[i] = report.timestamp_s;
    }
}

Fault SensorWatch::fault(double time_s) {
    if (newest_ && newest_->timestamp_s > time_s + params_.ahead_s) {
        // Forgotten, or every field with a right time stamp would count as older.
        const double ahead_s = newest_->timestamp_s - time_s;
        newest_.reset();
        arrived_ = partly_blind_ = false;
        return {GuardReason::SensorStale,
                sentence("the newest field is dated ", ahead_s, " s in the future")};
    }
    if (arrived_) last_arrival_s_ = time_s;
    arrived_ = false;
    partly_blind_ = false;
    if (Fault fault = stale(time_s)) return fault;
    if (Fault fault = unseeing()) return fault;
    Fault fault = blind_sector();
    partly_blind_ = static_cast<bool>(fault);
    return fault;
}

Fault SensorWatch::stale(double time_s) const {
    const auto because = [](const std::string& why) { return Fault{GuardReason::SensorStale, why}; };
    if (!newest_) return because("no field has come yet");
    const double age_s = time_s - newest_->timestamp_s;
    if (time_s - last_arrival_s_ > params_.stale_s) {
        return because(sentence("no field for ", time_s - last_arrival_s_, " s"));
    }
    if (age_s > params_.stale_s) return because(sentence("the newest field is ", age_s, " s old"));
    return {};
}

Fault SensorWatch::unseeing() const {
    const FieldStatus status = newest_->status;
    const double unseen_s = newest_->timestamp_s - last_seen_s_;
    const double more_s = status == FieldStatus::Waiting ? params_.waiting_s : 0.0;
    if (unseen_s > params_.blind_s + more_s) {
        return {GuardReason::SensorBlind,
                sentence("no field with enough vectors for ", unseen_s, " s: ", to_string(status))};
    }
    const double lost_s = newest_->timestamp_s - last_ok_s_;
    if (lost_s > params_.lost_s + more_s) {
        return {GuardReason::OmegaLost, sentence("no common motion of the vectors for ", lost_s, " s")};
    }
    return {};
}

Fault SensorWatch::blind_sector() const {
    std::string which;
    for (std::size_t i = 0; i < blind_since_s_.size(); ++i) {
        if (!blind_since_s_[i] || newest_->timestamp_s - *blind_since_s_[i] < params_.sector_s) continue;
        which += (which.empty() ? "" : ", ") + std::to_string(i + 1);
    }
    if (which.empty()) return {};
    return {GuardReason::SensorBlind, sentence("nothing seen in part ", which, " of ", SensorReport::sectors,
                                               " of the image, from the left")};
}

}  // namespace flownav::nav
