#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "flownav/pipeline/pipeline.h"
#include "flownav/testing/scene.h"

namespace flownav::testing {

/// How a test drives: with constant speed and turn rate.
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

/// The scene of such a drive: images with noise.
Scene drive(const DriveOptions& options);

std::vector<Field> render_fields(const Scene& scene);

/// The records of all fields, one after the other through one pipeline.
std::vector<pipeline::Step> run(const std::vector<Field>& fields, const pipeline::Params& params = {});

pipeline::Params cycles_of(int images);

/// A field like another one, all of one grey and `later_s` later.
Field grey_field(const Field& like, std::uint8_t grey, double later_s);

/// The same picture at another time.
Field delayed(Field field, double later_s);

/// Every number of a record, to the last bit.
std::string fingerprint(const pipeline::Step& step);

inline double to_deg(double angle_rad) {
    return angle_rad * 180.0 / M_PI;
}

}  // namespace flownav::testing
