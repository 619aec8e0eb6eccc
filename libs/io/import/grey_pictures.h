#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "flownav/core/field.h"

namespace flownav::io {

/// Loads the pictures of a recording as 8-bit grey images of one size. Pictures of 16 bits are scaled by the
/// bits that they use.
class GreyPictures {
  public:
    /// Looks at some of the pictures for the bits that they use.
    explicit GreyPictures(const std::vector<std::filesystem::path>& pictures);

    /// Image without time and camera; empty when it cannot be read, see why().
    std::optional<Field> load(const std::filesystem::path& file);

    /// Why the last load() failed, with the name of the file.
    const std::string& why() const { return why_; }

    /// What is mended, one sentence; empty when the pictures have 8 bits.
    std::string note() const;

    /// Tells of pictures that were brighter than expected, once all are loaded; empty when none was.
    std::string brighter() const;

  private:
    int bits_ = 8;  ///< that pictures of more than 8 bits use
    bool deep_ = false;
    std::size_t brighter_ = 0;
    int width_px_ = 0;  ///< of the first picture
    int height_px_ = 0;
    std::string why_;
};

}  // namespace flownav::io
