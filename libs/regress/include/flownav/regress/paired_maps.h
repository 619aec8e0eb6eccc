#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>

namespace flownav::regress {

/// A map as map.pgm and map.yaml have it: 0 is occupied, 254 free, 205 unknown, y up.
struct MapFile {
    cv::Mat cells;
    double left_m = 0.0, bottom_m = 0.0, cell_m = 0.0;
};

/// Nothing where the files are missing or damaged.
std::optional<MapFile> read_map(const std::filesystem::path& folder);

/// Two maps on the same cells: the part that one of them knows.
struct PairedMaps {
    cv::Mat before, after;  ///< as MapFile has them
    double left_m = 0.0, bottom_m = 0.0, cell_m = 0.0;
    int only_before = 0, only_after = 0, both = 0;  ///< occupied cells
};

/// Nothing where neither knows anything. Where the cells are of two sizes, or too many, an occupied cell is
/// not lost: it counts more than a free one, and that more than an unknown one.
std::optional<PairedMaps> paired(const MapFile& before, const MapFile& after);

/// The colours of a picture of differences, blue first.
struct DifferenceColours {
    cv::Vec3b only_before, only_after, both, free, unknown;
};
cv::Mat difference_picture(const PairedMaps& maps, const DifferenceColours& colours);

}  // namespace flownav::regress
