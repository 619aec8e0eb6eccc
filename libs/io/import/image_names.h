#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "flownav/io/time_unit.h"

namespace flownav::io {

/// What the names of a folder's images tell, image by image.
struct NameSeries {
    std::vector<std::size_t> numbers;  ///< rising numbers of the images; empty when the names are no series
    std::vector<double> stamps_s;      ///< times of the images; empty when the names are no times
    std::vector<std::string> notes;    ///< what was recognised, one sentence each
    std::string no_counter;            ///< why the numbers in the names count no images; empty: they do
    std::string refusal;               ///< why these images are no recording; empty: they are
};

/// Reads the numbers and times in the names of images, given in their natural order and without ending.
/// Times are numbers since 1970 in any unit (1403636579763555584), seconds with a decimal point
/// (1305031102.175304), seconds and their fraction (1403636579_763555584), or dates (20110926_130225_964).
/// With `unit` the number of each name is a time in this unit.
NameSeries read_names(const std::vector<std::string>& stems, std::optional<TimeUnit> unit);

/// Most frequent difference of rising numbers; 1 when there is only one number.
std::size_t usual_step(const std::vector<std::size_t>& numbers);

}  // namespace flownav::io
