#pragma once
#include <string>

#include "studio.h"

namespace flownav::fidelity {

// The parts of the page, in markdown; each begins with its heading.

/// Ego-motion, odometry, obstacles and movers, scene by scene, and detection by kind and range.
std::string scenes_section(const Studio& studio);

/// The same scenes with one ingredient changed or left out.
std::string ablation_section(const Studio& studio);

/// A camera that is not where it is believed to be.
std::string calibration_section(const Studio& studio);

/// Jumps of the motion, and starts without any knowledge.
std::string jumps_section(const Studio& studio);

/// The paper's own claims. Writes its pictures as STEM-*.svg into `folder`.
/// Throws std::runtime_error naming the file that cannot be written.
std::string paper_section(const Studio& studio, const std::filesystem::path& folder, const std::string& stem);

/// Recordings of real drives; says so where they are missing. Its picture becomes STEM-kitti.svg in `folder`.
/// Throws std::runtime_error naming the file that cannot be read or written.
std::string real_data_section(const std::filesystem::path& folder, const std::string& stem);

/// The whole page into `file`, with its pictures beside it.
/// Throws std::runtime_error naming the file that cannot be written.
void write_page(const Studio& studio, const std::filesystem::path& file);

/// Throws std::runtime_error naming the file that cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace flownav::fidelity
