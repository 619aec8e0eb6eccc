#include <csignal>
#include <iostream>

#include "open_window.h"

int main(int argc, char** argv) {
    // Makes a closed pipe or a file size limit an error of the write instead of a fatal signal.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    return flownav::view::run_view_app({argv, argv + argc}, flownav::view::open_window, std::cout, std::cerr);
}
