#include "targets.h"

#include <set>

namespace flownav::fidelity {
namespace {

Targets excellent() {
    Targets t;
    t.omega_image_degps = below(0.08);
    t.omega_cycle_degps = below(0.025);
    t.t_bias_percent = below(0.2);
    t.t_scatter_percent = below(0.3);
    t.ghosts_per_cycle = below(1.0);
    t.false_per_cycle = below(0.05);
    t.detected_percent = above(70.0);
    t.error_1_2_m = below(0.02);
    t.error_2_3_m = below(0.03);
    t.error_3_4_m = below(0.06);
    t.chair_percent = above(85.0);
    t.map_precise_percent = above(90.0);
    t.map_found_percent = above(65.0);
    return t;
}

Targets calm_but_wobbly() {
    Targets t = excellent();
    t.omega_cycle_degps = below(0.06);
    return t;
}

Targets poor_texture() {
    Targets t;
    t.omega_cycle_degps = below(0.06);
    t.t_bias_percent = below(1.0);
    t.false_per_cycle = below(0.3);
    t.ghosts_per_cycle = below(1.0);
    return t;
}

Targets no_texture() {
    Targets t;
    t.omega_cycle_degps = below(0.1);
    t.ghosts_per_cycle = below(0.1);
    return t;
}

Targets vibrating() {
    Targets t;
    t.omega_cycle_degps = below(0.03);
    t.t_scatter_percent = below(1.0);
    t.ghosts_per_cycle = below(1.0);
    t.false_per_cycle = below(0.05);
    return t;
}

Targets told_by_wheels() {
    Targets t = no_texture();
    t.detected_percent = above(60.0);
    return t;
}

Targets with_mover(double omega_degps) {
    Targets t;
    t.covered_degps = below(omega_degps);
    t.heading_deg = below(1.0);
    return t;
}

}  // namespace

Targets targets_of(const std::string& scene) {
    static const std::set<std::string> only_reported = {"vibration03", "blur", "noise5", "noise10"};
    if (only_reported.count(scene) > 0) return {};
    if (scene == "tiles" || scene == "flicker") return calm_but_wobbly();
    if (scene == "lino") return poor_texture();
    if (scene == "plain") return no_texture();
    if (scene == "plain, wheels") return told_by_wheels();
    if (scene == "vibration015") return vibrating();
    if (scene == "mover45") return with_mover(0.1);
    if (scene == "mover25") return with_mover(1.0);
    return excellent();
}

}  // namespace flownav::fidelity
