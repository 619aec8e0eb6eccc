#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <iostream>

#include "grab_app.h"

namespace {

/// A standard stream that is closed would become the recording, and whatever a driver prints go into it.
void open_standard_streams() {
    int descriptor = 0;
    while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = open("/dev/null", O_RDWR);
    if (descriptor > STDERR_FILENO) close(descriptor);
}

}  // namespace

int main(int argc, char** argv) {
    open_standard_streams();
    const flownav::cli::StopSignals signals;
    // A closed pipe or a limit on file sizes shall be an error of the write, not the end of the program.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    return flownav::run_grab_app({argv, argv + argc}, signals, std::cout, std::cerr);
}
