#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cstdint>
#include <filesystem>

#include "flownav/core/field.h"
#include "flownav/io/video_output_file.h"
#include "flownav/pipeline/step.h"
#include "flownav/report/held_contacts.h"
#include "flownav/report/map_window.h"

namespace flownav::report {

/// A video (H.264 in MP4, 25 pictures a second) of a drive: the annotated field, side by side with the map as
/// it was known at that moment. It runs as fast as the drive did, whatever the camera's rate; of a pause in
/// the recording one second is shown. The same drive gives the same bytes.
class DriveVideo {
  public:
    static constexpr double rate_hz = 25.0;
    static constexpr double longest_pause_s = 1.0;

    /// Shows map_size_m metres of the map. Throws OutputError when `file` cannot be written.
    DriveVideo(std::filesystem::path file, double map_size_m);

    /// Adds the pictures that are due. Fields come with rising time stamps.
    void write(const Field& field, const pipeline::Step& step, const mrpt::maps::COccupancyGridMap2D& map);

    /// Completes the file. Throws OutputError when it did not become a whole video, as on a full disk.
    void close() { file_.close(); }

    /// Pictures written so far.
    std::uint64_t frames() const { return file_.pictures(); }

  private:
    void remember(const pipeline::Step& step);
    void put();

    io::VideoOutputFile file_;
    double map_size_m_;
    MapWindowScene scene_;
    HeldContacts contacts_;
    double driven_m_ = 0.0;
    double start_s_ = 0.0;
    double last_s_ = 0.0;
    double due_s_ = 0.0;
    cv::Size canvas_px_;  ///< decided by the first field
    cv::Mat picture_;
};

}  // namespace flownav::report
