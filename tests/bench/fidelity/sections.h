#pragma once
#include <string>

#include "studio.h"

namespace flownav::fidelity {

// Each returns a section of the page, in markdown with its heading.

/// Ego-motion, odometry, obstacles and moving objects by scene, and detection by kind and range.
std::string scenes_section(const Studio& studio);

/// The same scenes with one component changed or left out.
std::string ablation_section(const Studio& studio);

/// Results for a camera with a wrong assumed mount.
std::string calibration_section(const Studio& studio);

/// Jumps of the motion, and starts without prior knowledge.
std::string jumps_section(const Studio& studio);

/// The claims of the paper. Writes its pictures as STEM-*.svg to `folder`. Throws std::runtime_error naming
/// the file that cannot be written.
std::string paper_section(const Studio& studio, const std::filesystem::path& folder, const std::string& stem);

/// Recordings of real drives, with a note for each missing one. Writes its picture to STEM-kitti.svg in
/// `folder`. Throws std::runtime_error naming the file that cannot be read or written.
std::string real_data_section(const std::filesystem::path& folder, const std::string& stem);

/// Writes the whole page to `file`, with its pictures beside it. Throws std::runtime_error naming the file
/// that cannot be written.
void write_page(const Studio& studio, const std::filesystem::path& file);

/// Writes a text file. Throws std::runtime_error naming the file that cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace flownav::fidelity
