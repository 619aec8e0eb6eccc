#pragma once
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "view_picture.h"

namespace flownav::view {

/// What the command line asks for.
struct ViewCommand {
    ViewOptions options;
    cv::Size size{1440, 900};
    std::string screenshot;                     ///< file; empty: open a window
    double at_s = 0.0;                          ///< from the start of the drive
    std::optional<Eigen::Vector2d> pointed_px;  ///< at this pixel of the field
    bool print_state = false;
    std::string live;                      ///< ini of a live source instead of a rawlog
    std::function<std::string()> problem;  ///< of the live source, empty while it runs; may be null
};

/// Opens a window on the model and returns the exit status when it has been closed.
using OpenWindow = std::function<int(ViewModel&, const ViewCommand&, std::ostream& out, std::ostream& error)>;

/// The program flownav-view; arguments[0] is its name. Returns its exit status.
int run_view_app(const std::vector<std::string>& arguments, const OpenWindow& open_window, std::ostream& out,
                 std::ostream& error);

}  // namespace flownav::view
