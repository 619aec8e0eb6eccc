#include "flownav/core/field_status.h"
#include "flownav/core/flow_vector.h"

namespace flownav {

const char* to_string(FieldStatus status) {
    switch (status) {
        case FieldStatus::Ok:
            return "ok";
        case FieldStatus::Waiting:
            return "waiting";
        case FieldStatus::Lost:
            return "lost";
        case FieldStatus::NoTexture:
            return "no_texture";
        case FieldStatus::BadField:
            return "bad_field";
    }
    return "unknown";
}

const char* to_string(FieldFault fault) {
    switch (fault) {
        case FieldFault::None:
            return "none";
        case FieldFault::NoPicture:
            return "no_picture";
        case FieldFault::WrongSize:
            return "wrong_size";
        case FieldFault::BadCamera:
            return "bad_camera";
        case FieldFault::TimeNotRising:
            return "time_not_rising";
    }
    return "unknown";
}

const char* to_string(BlockFate fate) {
    switch (fate) {
        case BlockFate::Unplaced:
            return "unplaced";
        case BlockFate::Sifted:
            return "sifted";
        case BlockFate::Eliminated:
            return "eliminated";
        case BlockFate::Ground:
            return "ground";
        case BlockFate::Obstacle:
            return "obstacle";
        case BlockFate::Moving:
            return "moving";
        case BlockFate::Unsupported:
            return "unsupported";
        case BlockFate::Unjudged:
            return "unjudged";
    }
    return "unknown";
}

}  // namespace flownav
