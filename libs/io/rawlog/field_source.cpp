#include "flownav/io/field_source.h"

#include <utility>

namespace flownav::io {

std::optional<ReplayEvent> FieldSource::next() {
    auto event = order_.pop();
    while (!event && !finished_ && !error_) {
        advance();
        event = order_.pop();
    }
    if (!event && error_) std::rethrow_exception(std::exchange(error_, nullptr));
    return event;
}

/// Reads one more observation, or the end.
void FieldSource::advance() {
    const mrpt::obs::CObservation::Ptr observation = reader_.next();
    maker_.count_objects(reader_.end().objects_read);
    finished_ = !observation;
    try {
        if (finished_) {
            maker_.finish();
        } else {
            maker_.consume(observation, reader_.images_directory());
        }
    } catch (const config::ConfigError&) {
        error_ = std::current_exception();
        maker_.finish();
    }
    while (const auto event = maker_.next()) order_.push(*event);
    if (finished_ || error_) order_.flush();
}

}  // namespace flownav::io
