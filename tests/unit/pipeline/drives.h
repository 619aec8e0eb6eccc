#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "flownav/pipeline/pipeline.h"
#include "flownav/testing/scene.h"

namespace flownav::testing {

/// Motion and scene of a drive with constant speed and turn rate.
struct DriveOptions {
    SceneKind kind = SceneKind::Free;
    int images = 6;
    double v_mps = 0.4;
    double omega_degps = 0.0;
    double rate_hz = 25.0;
    bool interlaced = false;
    Surface floor = Surface::Carpet;
    CameraModel camera = standard_camera();
};

/// The scene of a drive: images with noise.
Scene drive(const DriveOptions& options);

std::vector<Field> render_fields(const Scene& scene);

/// Runs all fields through one pipeline and returns the records.
std::vector<pipeline::Step> run(const std::vector<Field>& fields, const pipeline::Params& params = {});

pipeline::Params cycles_of(int images);

/// A field like `like`, all of one grey value and `later_s` later.
Field grey_field(const Field& like, std::uint8_t grey, double later_s);

/// The same image at another time.
Field delayed(Field field, double later_s);

/// Text of every number of a record, exact to the last bit.
std::string fingerprint(const pipeline::Step& step);

}  // namespace flownav::testing
