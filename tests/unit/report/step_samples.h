#pragma once
#include <memory>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/evaluation/drive.h"
#include "flownav/pipeline/step.h"
#include "flownav/report/thumbnail_strip.h"

/// Hand-made steps, fields and drives for the tests of the outputs.
namespace flownav::testing {

constexpr double start_s = 1000.0;
constexpr double period_s = 0.04;
constexpr int cycle_images = 4;

/// Field i of a drive with constant turn rate and speed; every fourth ends a cycle.
pipeline::Step step_at(int i, double omega_radps = 0.2, double v_mps = 0.4);

/// A grey ramp with the size of a PAL field.
Field pal_field(int i);

/// A drive of such fields before the outputs are finished, with exact odometry and ground truth.
evaluation::Drive sample_drive(int fields);

/// The thumbnails of such a drive.
report::ThumbnailStrip sample_thumbnail_strip(int fields);

/// Content of a file; fails the test when it cannot be read.
std::string content(const std::filesystem::path& file);

}  // namespace flownav::testing
