#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>

namespace flownav::regress {

/// A map as in map.pgm and map.yaml: 0 is occupied, 254 free, 205 unknown, y up.
struct MapFile {
    cv::Mat cells;
    double left_m = 0.0, bottom_m = 0.0, cell_m = 0.0;
};

/// Reads a map; empty when the files are missing or damaged.
std::optional<MapFile> read_map(const std::filesystem::path& folder);

/// Two maps on the same cells, cropped to the part that is known in either.
struct PairedMaps {
    cv::Mat before, after;  ///< values as in MapFile
    double left_m = 0.0, bottom_m = 0.0, cell_m = 0.0;
    int only_before = 0, only_after = 0, both = 0;  ///< numbers of occupied cells
};

/// Pairs two maps; empty when both are unknown everywhere. Where several cells fall on one, occupied takes
/// precedence over free, and free over unknown.
std::optional<PairedMaps> paired(const MapFile& before, const MapFile& after);

/// Colours of a picture of differences, in the order blue, green, red.
struct DifferenceColours {
    cv::Vec3b only_before, only_after, both, free, unknown;
};
cv::Mat difference_picture(const PairedMaps& maps, const DifferenceColours& colours);

}  // namespace flownav::regress
