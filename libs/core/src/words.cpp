#include "flownav/core/contact_scan.h"
#include "flownav/core/ego_motion.h"
#include "flownav/core/field_status.h"
#include "flownav/core/flow_vector.h"
#include "flownav/core/sensor_agreement.h"

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

const char* to_string(BlockLabel label) {
    switch (label) {
        case BlockLabel::Unplaced:
            return "unplaced";
        case BlockLabel::Sifted:
            return "sifted";
        case BlockLabel::Eliminated:
            return "eliminated";
        case BlockLabel::Ground:
            return "ground";
        case BlockLabel::Obstacle:
            return "obstacle";
        case BlockLabel::Moving:
            return "moving";
        case BlockLabel::Unsupported:
            return "unsupported";
        case BlockLabel::Unjudged:
            return "unjudged";
    }
    return "unknown";
}

const char* to_string(BeamKind kind) {
    switch (kind) {
        case BeamKind::Unknown:
            return "unknown";
        case BeamKind::Free:
            return "free";
        case BeamKind::Obstacle:
            return "obstacle";
    }
    return "unknown";
}

const char* to_string(BeamCause cause) {
    switch (cause) {
        case BeamCause::None:
            return "none";
        case BeamCause::Blocks:
            return "blocks";
        case BeamCause::Votes:
            return "votes";
        case BeamCause::Wall:
            return "wall";
        case BeamCause::Drop:
            return "drop";
    }
    return "unknown";
}

const char* to_string(ContactGate gate) {
    switch (gate) {
        case ContactGate::Open:
            return "open";
        case ContactGate::Off:
            return "off";
        case ContactGate::NoTravel:
            return "no_travel";
        case ContactGate::PoorFloor:
            return "poor_floor";
    }
    return "unknown";
}

const char* to_string(MotionSource source) {
    switch (source) {
        case MotionSource::Prediction:
            return "prediction";
        case MotionSource::Flow:
            return "flow";
        case MotionSource::Wheels:
            return "wheels";
        case MotionSource::Gyro:
            return "gyro";
    }
    return "unknown";
}

const char* to_string(SensorAgreement agreement) {
    switch (agreement) {
        case SensorAgreement::NoReadings:
            return "no_readings";
        case SensorAgreement::Unchecked:
            return "unchecked";
        case SensorAgreement::Agrees:
            return "agrees";
        case SensorAgreement::Contradicts:
            return "contradicts";
        case SensorAgreement::NotInTime:
            return "not_in_time";
    }
    return "unknown";
}

}  // namespace flownav
