#include <csignal>
#include <iostream>

#include "flownav/cli/stop_signals.h"
#include "nav_app.h"

int main(int argc, char** argv) {
    const flownav::cli::StopSignals signals;
    // A closed pipe or a limit on file sizes shall be an error of the write, not the end of the program.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    const flownav::StopRequest stop{[&signals] { return signals.wait(std::chrono::milliseconds(0)); },
                                    [&signals] { signals.release(); }};
    return flownav::run_nav_app({argv, argv + argc}, stop, std::cout, std::cerr);
}
