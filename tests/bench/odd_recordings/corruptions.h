#pragma once
#include <mrpt/obs/CObservation.h>

#include <functional>
#include <random>
#include <string>
#include <vector>

/// Recordings with wrong meta data, made of a good one.
namespace flownav::bench {

using Recording = std::vector<mrpt::obs::CObservation::Ptr>;
using Dice = std::mt19937_64;

/// One kind of wrong meta data.
struct Corruption {
    std::string name;
    /// Changes the observations, which are copies.
    std::function<void(Recording&, Dice&)> apply;
};

const std::vector<Corruption>& corruptions();

/// Copies the observations; images share their pixels.
Recording copy_of(const Recording& recording);

}  // namespace flownav::bench
