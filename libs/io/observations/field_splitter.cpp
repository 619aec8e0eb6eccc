#include "flownav/io/field_splitter.h"

#include <algorithm>

#include "flownav/io/camera_conversion.h"

namespace flownav::io {
namespace {

constexpr std::size_t intervals_kept = 9;
constexpr double pal_frame_period_s = 0.04;

double median(const std::deque<double>& values) {
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
}

}  // namespace

Field field_of_frame(const Field& frame, bool bottom) {
    Field field = frame;
    field.image.data = frame.image.row(bottom ? 1 : 0);
    field.image.height_px = frame.image.height_px / 2;
    field.image.stride_bytes = 2 * frame.image.stride_bytes;
    field.camera = field_camera(frame.camera, bottom);
    return field;
}

std::vector<Field> FieldSplitter::push(const Field& frame) {
    if (interlaced_ == config::Interlaced::None) return {frame};
    std::vector<Field> fields;
    if (second_) {
        const double interval_s = frame.timestamp_s - second_->timestamp_s;
        intervals_s_.push_back(interval_s);
        if (intervals_s_.size() > intervals_kept) intervals_s_.pop_front();
        // The field must lie between the two frames, also when the second one is early.
        fields.push_back(second_field(std::min(median(intervals_s_), interval_s)));
    }
    const bool bottom_first = interlaced_ == config::Interlaced::BottomFirst;
    fields.push_back(field_of_frame(frame, bottom_first));
    second_ = field_of_frame(frame, !bottom_first);
    return fields;
}

std::vector<Field> FieldSplitter::finish() {
    if (!second_) return {};
    return {second_field(intervals_s_.empty() ? pal_frame_period_s : median(intervals_s_))};
}

Field FieldSplitter::second_field(double period_s) {
    Field field = *second_;
    field.timestamp_s += period_s / 2;
    second_.reset();
    return field;
}

}  // namespace flownav::io
