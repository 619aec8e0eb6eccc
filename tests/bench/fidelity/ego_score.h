#pragma once
#include "chain_run.h"
#include "statistics.h"

namespace flownav::fidelity {

constexpr int settling_images = 10;  ///< the first images are not evaluated

/// Ego-motion and odometry against the truth, over one or several drives.
struct EgoScore {
    Share ok;                 ///< images whose turn rate was measured
    Moments omega_degps;      ///< error per image
    Moments cycle_degps;      ///< mean error of a cycle
    Moments pitch_degps;      ///< error of the pitch rate per image
    Moments v_percent;        ///< error of the speed where a cycle measured it
    Share v_measured;         ///< finished cycles that measured the speed
    Moments end_percent;      ///< distance between the ends of the tracks, one per drive, % of the path
    Moments heading_deg;      ///< difference of the final headings, one per drive
    Moments covered_degps;    ///< error of omega while a moving object covers at least half of the blocks
    double covered_most = 0;  ///< largest share of the blocks covered by a moving object
    double path_m = 0.0;

    void add(const EgoScore& other);
};

class EgoWatcher {
  public:
    void see(const Moment& moment);
    EgoScore result() const;

  private:
    void see_omega(const Moment& moment);
    void see_speed(const Moment& moment);
    void finish_cycle();

    EgoScore score_;
    Moments cycle_;
    double covered_ = 0.0;
    Pose2 first_flow_, first_truth_, last_flow_, last_truth_;
};

/// Share of the blocks that show a moving object.
double covered_by_movers(const Moment& moment);

}  // namespace flownav::fidelity
