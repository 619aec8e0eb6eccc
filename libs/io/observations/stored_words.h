#pragma once
#include <array>

#include "flownav/core/contact_scan.h"
#include "flownav/core/ego_motion.h"
#include "flownav/core/field_status.h"
#include "flownav/core/flow_vector.h"

/// Values of enums in the order of their stored numbers: append new values, never reorder.
namespace flownav::io::archive {

inline constexpr std::array stored_statuses = {FieldStatus::Ok, FieldStatus::Waiting, FieldStatus::Lost,
                                               FieldStatus::NoTexture, FieldStatus::BadField};
inline constexpr std::array stored_labels = {
    BlockLabel::Unplaced, BlockLabel::Sifted, BlockLabel::Eliminated,  BlockLabel::Ground,
    BlockLabel::Obstacle, BlockLabel::Moving, BlockLabel::Unsupported, BlockLabel::Unjudged};
inline constexpr std::array stored_kinds = {BeamKind::Unknown, BeamKind::Free, BeamKind::Obstacle};
inline constexpr std::array stored_causes = {BeamCause::None, BeamCause::Blocks, BeamCause::Votes,
                                             BeamCause::Wall, BeamCause::Drop};
inline constexpr std::array stored_gates = {ContactGate::Open, ContactGate::Off, ContactGate::NoTravel,
                                            ContactGate::PoorFloor};
inline constexpr std::array stored_sources = {MotionSource::Prediction, MotionSource::Flow,
                                              MotionSource::Wheels, MotionSource::Gyro};

}  // namespace flownav::io::archive
