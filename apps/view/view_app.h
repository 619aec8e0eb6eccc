#pragma once
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "view_picture.h"

namespace flownav::view {

/// Parsed command line of flownav-view.
struct ViewCommand {
    ViewOptions options;
    cv::Size size{1440, 900};
    std::string screenshot;                     ///< file; empty: open a window
    double at_s = 0.0;                          ///< since the start of the drive
    std::optional<Eigen::Vector2d> pointed_px;  ///< pixel of the field to point at
    bool print_state = false;
    std::string live;                      ///< ini of a live source instead of a rawlog
    std::function<std::string()> problem;  ///< message of the live source, empty while it runs; may be null
};

/// Opens a window on the model; returns the exit status when the window is closed.
using OpenWindow = std::function<int(ViewModel&, const ViewCommand&, std::ostream& out, std::ostream& error)>;

/// Runs flownav-view; arguments[0] is its name. Returns the exit status.
int run_view_app(const std::vector<std::string>& arguments, const OpenWindow& open_window, std::ostream& out,
                 std::ostream& error);

}  // namespace flownav::view
