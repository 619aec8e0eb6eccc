#pragma once
#include "flownav/drive/simulated_drive.h"
#include "flownav/report/drive_picture.h"

namespace flownav {

/// The drive as its picture shows it. In a simulation it has the true way and the outlines of the world at
/// the end of the drive.
report::DriveScene drive_scene(const drive::SimulatedDriveOptions& options, const drive::DriveResult& result);

}  // namespace flownav
