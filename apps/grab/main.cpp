#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <iostream>

#include "grab_app.h"

namespace {

/// Opens closed standard streams; otherwise the recording would get their descriptor and receive a driver's
/// output.
void open_standard_streams() {
    int descriptor = 0;
    while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = open("/dev/null", O_RDWR);
    if (descriptor > STDERR_FILENO) close(descriptor);
}

}  // namespace

int main(int argc, char** argv) {
    open_standard_streams();
    const flownav::cli::StopSignals signals;
    // Makes a closed pipe or a file size limit an error of the write instead of a fatal signal.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    return flownav::run_grab_app({argv, argv + argc}, signals, std::cout, std::cerr);
}
