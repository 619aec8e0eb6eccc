#include "open_window.h"

#include "flownav/cli/exit_status.h"
#include "flownav/replay/replay.h"
#include "view_window.h"

namespace flownav::view {

int open_window(ViewModel& model, const ViewCommand& command, std::ostream& out, std::ostream& error) {
    ViewSession session(model, command, out);
    nanogui::ref<ViewWindow> window;
    try {
        nanogui::init();
        window = new ViewWindow(session);
    } catch (const std::exception& exception) {
        error << "flownav-view: no window can be opened here (" << exception.what()
              << "); use --screenshot, or set DISPLAY\n";
        return cli::exit_code(cli::ExitStatus::Usage);
    }
    window->run();
    window = nullptr;
    nanogui::shutdown();
    return 0;
}

}  // namespace flownav::view
