#pragma once
#include "view_app.h"

namespace flownav::view {

/// Shows the model in a window until that is closed. Returns the exit status: 1 without a display.
int open_window(ViewModel& model, const ViewCommand& command, std::ostream& out, std::ostream& error);

}  // namespace flownav::view
