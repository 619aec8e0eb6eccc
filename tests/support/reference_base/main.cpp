#include <mrpt/3rdparty/tclap/CmdLine.h>

#include <csignal>
#include <iostream>

#include "flownav/testing/reference_base.h"

namespace {

volatile std::sig_atomic_t ended = 0;

}  // namespace

int main(int argc, char** argv) {
    try {
        TCLAP::CmdLine arguments("A simulated robot that speaks the line protocol of --robot tcp:HOST:PORT");
        TCLAP::ValueArg<int> port("p", "port", "to listen on, loopback only; 0: the system chooses", false, 0,
                                  "number", arguments);
        TCLAP::ValueArg<double> rate("r", "rate", "odometry lines a second", false, 50.0, "Hz", arguments);
        TCLAP::ValueArg<int> timeout("t", "timeout", "stops by itself after so long without a command", false,
                                     300, "ms", arguments);
        arguments.parse(argc, argv);
        flownav::testing::ReferenceBaseOptions options;
        options.port = port.getValue();
        options.rate_hz = rate.getValue();
        options.timeout_ms = timeout.getValue();
        flownav::testing::ReferenceBase base(options);
        std::signal(SIGINT, [](int) { ended = 1; });
        std::signal(SIGTERM, [](int) { ended = 1; });
        std::cout << "listening on port " << base.port() << std::endl;
        base.serve([] { return ended != 0; });
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
    return 0;
}
