#include <csignal>
#include <iostream>

#include "view_app.h"

int main(int argc, char** argv) {
    // A closed pipe or a limit on file sizes shall be an error of the write, not the end of the program.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    const auto no_window = [](auto&, auto&, auto&, auto& error) {
        error << "flownav-view: no window yet\n";
        return 1;
    };
    return flownav::view::run_view_app({argv, argv + argc}, no_window, std::cout, std::cerr);
}
