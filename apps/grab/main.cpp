#include <csignal>
#include <iostream>

#include "grab_app.h"

int main(int argc, char** argv) {
    const flownav::StopSignals signals;
    // A closed pipe or a limit on file sizes shall be an error of the write, not the end of the program.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    return flownav::run_grab_app({argv, argv + argc}, signals, std::cout, std::cerr);
}
