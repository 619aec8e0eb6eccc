#pragma once
#include <vector>

#include "flownav/motion/estimate_motion.h"

namespace flownav::motion {

/// Background separation after [S] (Stoeffler, Schnepf, ICPR 1998). Sorts the samples and joins neighbours
/// whose gap is below `gap_rad` into clusters. The background is the cluster with the largest spatial
/// variance in the image among those with at least 8 % of the samples. Returns the shorth (6) of the
/// background's omega in rad, or of all samples when no cluster is large enough. Sorts `samples`; `values` is
/// working memory.
double background_omega(std::vector<OmegaSample>& samples, double gap_rad, std::vector<double>& values);

}  // namespace flownav::motion
