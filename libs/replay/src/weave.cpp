#include "weave.h"

#include "flownav/sensor/camera_conversion.h"

namespace flownav {

Field field_of_frame(const Field& frame, bool bottom) {
    Field field = frame;
    field.image.data = frame.image.row(bottom ? 1 : 0);
    field.image.height_px = frame.image.height_px / 2;
    field.image.stride_bytes = 2 * frame.image.stride_bytes;
    field.camera = field_camera(frame.camera, bottom);
    return field;
}

}  // namespace flownav
