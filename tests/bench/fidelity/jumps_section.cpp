#include "flownav/math/units.h"
#include "flownav/sim/random.h"
#include "flownav/testing/effects.h"
#include "flownav/testing/render.h"
#include "markdown.h"
#include "sections.h"

namespace flownav::fidelity {
namespace {

constexpr int trials = 100;
constexpr double right_degps = 1.0;
constexpr int longest_cycle = 16;

/// A stretch of `primed` images of a drive, followed by one image with another motion.
struct Trial {
    int first = 0;
    int primed = 1;
    double omega_degps = 0.0;
    double v_mps = 0.0;
};

double either_sign(sim::HashRandom& random, double least, double most) {
    const double size = random.uniform(least, most);
    return random.uniform(0.0, 1.0) < 0.5 ? -size : size;
}

/// Trial in which the turn rate jumps by 20 to 60 deg/s in the middle of a drive; every second trial changes
/// the speed too.
Trial jump_trial(const testing::Scene& scene, int k) {
    sim::HashRandom random(sim::mix(scene.options.seed, 1000U + static_cast<std::uint64_t>(k)));
    Trial trial;
    trial.primed = 8 + static_cast<int>(random.uniform(0.0, 5.0));
    trial.first = static_cast<int>(random.uniform(0.0, scene.images() - trial.primed - longest_cycle));
    const auto last = static_cast<std::size_t>(trial.first + trial.primed - 1);
    const EgoMotion before = testing::exact_motion(scene.poses[last - 1], scene.poses[last]);
    trial.omega_degps = deg(before.omega_rad) * scene.options.rate_hz + either_sign(random, 20.0, 60.0);
    trial.v_mps = k % 2 == 0 ? scene.options.speed_mps : random.uniform(0.1, 0.8);
    return trial;
}

/// Trial with two images and no prior knowledge: up to 60 deg/s and 0.8 m/s.
Trial cold_trial(const testing::Scene& scene, int k) {
    sim::HashRandom random(sim::mix(scene.options.seed, 5000U + static_cast<std::uint64_t>(k)));
    Trial trial;
    trial.first = static_cast<int>(random.uniform(0.0, scene.images()));
    trial.omega_degps = random.uniform(-60.0, 60.0);
    trial.v_mps = random.uniform(0.1, 0.8);
    return trial;
}

/// Extends `primed` to the end of the running cycle.
Trial to_end_of_cycle(const RenderedScene& drive, Trial trial) {
    pipeline::State state{pipeline::Params{}};
    for (int i = trial.first; i < trial.first + trial.primed + longest_cycle; ++i) {
        const bool ended = pipeline::step(state, drive.fields[static_cast<std::size_t>(i)]).end_of_cycle;
        if (!ended || i + 1 < trial.first + trial.primed) continue;
        trial.primed = i + 1 - trial.first;
        break;
    }
    return trial;
}

bool right_at_once(const RenderedScene& drive, const Trial& trial, int k) {
    const testing::Scene& scene = drive.scene;
    const int last = trial.first + trial.primed - 1;
    const double image_s = 1.0 / scene.options.rate_hz;
    sim::View view = testing::nominal_view(scene, last);
    view.time_s += image_s;
    view.T_world_robot = compose(view.T_world_robot,
                                 along_arc(trial.omega_degps * degree_rad * image_s, trial.v_mps * image_s));
    const testing::GreyImage image = testing::render(
        scene.world, view, testing::effects_of_image(scene.options.effects, 10 * scene.images() + k));
    pipeline::State state{pipeline::Params{}};
    for (int i = trial.first; i <= last; ++i)
        pipeline::step(state, drive.fields[static_cast<std::size_t>(i)]);
    const pipeline::Step& step =
        pipeline::step(state, {testing::scene_start_s + view.time_s, image.view(), view.camera, nullptr});
    return step.status == FieldStatus::Ok &&
           std::abs(deg(step.omega_radps) - trial.omega_degps) < right_degps;
}

Share share_right(const RenderedScene& drive, const std::function<Trial(int)>& trial) {
    std::vector<char> right(trials);
    in_parallel(trials, [&](int k) {
        right[static_cast<std::size_t>(k)] = right_at_once(drive, trial(k), k) ? 1 : 0;
    });
    Share share;
    for (const char hit : right) share.add(hit != 0);
    return share;
}

}  // namespace

std::string jumps_section(const Studio& studio) {
    Table table{{"floor", "jump anywhere in a cycle (%)", "jump between two cycles (%)", "cold start (%)"},
                {}};
    for (const auto& [name, target] : {std::pair{"carpet", above(97.0)}, std::pair{"tiles", above(93.0)},
                                       std::pair{"lino", above(93.0)}}) {
        const RenderedScene drive = studio.scene(name);
        const Share anywhere = share_right(drive, [&](int k) { return jump_trial(drive.scene, k); });
        const Share between =
            share_right(drive, [&](int k) { return to_end_of_cycle(drive, jump_trial(drive.scene, k)); });
        const Share cold = share_right(drive, [&](int k) { return cold_trial(drive.scene, k); });
        table.rows.push_back({name, cell(anywhere.percent(), 0, target), cell(between.percent(), 0, target),
                              cell(cold.percent(), 0)});
        studio.say(std::string("  ") + name);
    }
    return "## Jumps of the motion and cold starts\n\nShare of " + std::to_string(trials) +
           " seeded trials in which the turn rate is within 1 deg/s of the truth, with status `ok`, in the\n"
           "FIRST image after the jump. A jump: in the middle of a drive the turn rate changes from one "
           "image "
           "to the next by 20 to\n60 deg/s to either side, in every second trial the speed too, to anything "
           "from 0.1 to 0.8 m/s. A search window alone\nreaches 18 deg/s. A cold start: two images, anything "
           "up to 60 deg/s to either side and 0.1 to 0.8 m/s.\n\n" +
           to_markdown(table);
}

}  // namespace flownav::fidelity
