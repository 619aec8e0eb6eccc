#include "flownav/io/flow_field_file.h"

#include "flownav/io/flow_field_observation.h"

namespace flownav::io {

void FlowFieldFile::write(const Field& field, const pipeline::Step& step) {
    write_object(file_, *flow_field_observation(step, field.camera));
}

}  // namespace flownav::io
