#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "image_times.h"
#include "times_list.h"

namespace flownav::io {

/// Names of the images without folder and ending.
std::vector<std::string> stems_of(const std::vector<std::filesystem::path>& images);

/// Gives the images the times of a list: by the names or the numbers in it, by the times or the numbers in
/// the names of the images, or by their order when there are as many times as images. Throws InputError when
/// they cannot be matched without doubt.
void match_list(const TimesList& list, const std::vector<std::filesystem::path>& images,
                ImageSchedule& schedule);

}  // namespace flownav::io
