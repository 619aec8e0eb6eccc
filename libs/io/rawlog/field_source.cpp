#include "flownav/io/field_source.h"

namespace flownav::io {

std::optional<ReplayEvent> FieldSource::next() {
    auto event = maker_.next();
    while (!event && !finished_) {
        const mrpt::obs::CObservation::Ptr observation = reader_.next();
        maker_.count_objects(reader_.end().objects_read);
        finished_ = !observation;
        if (finished_) {
            maker_.finish();
        } else {
            maker_.consume(observation, reader_.images_directory());
        }
        event = maker_.next();
    }
    return event;
}

}  // namespace flownav::io
