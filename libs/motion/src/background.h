#pragma once
#include <vector>

#include "flownav/motion/estimate_motion.h"

namespace flownav::motion {

/// Background separation after [S] (Stoeffler, Schnepf, ICPR 1998): the samples are sorted and joined while
/// the gap between neighbours stays below `gap_rad`; of the clusters with at least 8 % of the samples the
/// background is the one that is spread widest over the image, which need not be the largest. Returns the
/// shorth (6) of the background, or of all samples when no cluster is large enough. Sorts `samples`; `values`
/// is working memory.
double background_omega(std::vector<OmegaSample>& samples, double gap_rad, std::vector<double>& values);

}  // namespace flownav::motion
