#pragma once

#include <nlohmann/json_fwd.hpp>
#include <opencv2/core/matx.hpp>
#include <string>

#include "flownav/regress/run_results.h"

namespace flownav::regress {

/// The colours of the two runs. Neither is one of those that say better or worse.
struct RunColours {
    cv::Vec3b before = {122, 158, 0};  ///< blue first, as pictures have it
    cv::Vec3b after = {118, 27, 197};
    cv::Vec3b truth = {185, 185, 185};
};

/// "#c51b76".
std::string css_colour(const cv::Vec3b& colour);

/// Ways, maps and curves of one rawlog in two runs, for the page; null where a run kept only its figures.
nlohmann::ordered_json drive_pair(const RawlogResult& before, const RawlogResult& after);

}  // namespace flownav::regress
