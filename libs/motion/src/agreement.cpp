#include "flownav/motion/agreement.h"

#include <algorithm>
#include <cmath>

namespace flownav::motion {
namespace {

constexpr double sigmas = 2.0;  // differences up to so many standard deviations count as none

}  // namespace

void Agreement::note(const Pair& pair) {
    pairs_.push(pair);
    double amount = 0.0, excess = 0.0, products = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        const Pair& p = pairs_[i];
        if (pair.end_s - p.end_s > window_s) continue;
        amount += std::max(std::abs(p.flow), std::abs(p.other));
        excess += std::max(0.0, std::abs(p.other - p.flow) - sigmas * p.sigma);
        products += p.other * p.flow;
        squares += p.flow * p.flow;
    }
    const double limit = limits_.slack + limits_.share * amount;
    const bool was_wrong = verdict_ == SensorAgreement::Contradicts;
    ratio_ = amount >= limits_.amount_min && squares > 0.0 ? products / squares : 1.0;
    if (excess > (was_wrong ? 0.5 : 1.0) * limit) {
        verdict_ = SensorAgreement::Contradicts;
    } else {
        verdict_ = amount >= limits_.amount_min ? SensorAgreement::Agrees : SensorAgreement::Unchecked;
    }
}

}  // namespace flownav::motion
