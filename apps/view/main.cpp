#include <csignal>
#include <iostream>

#include "open_window.h"

int main(int argc, char** argv) {
    // A closed pipe or a limit on file sizes shall be an error of the write, not the end of the program.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    return flownav::view::run_view_app({argv, argv + argc}, flownav::view::open_window, std::cout, std::cerr);
}
