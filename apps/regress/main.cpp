#include <csignal>
#include <iostream>

#include "regress_app.h"

int main(int argc, char** argv) {
    // A closed pipe or a limit on file sizes shall be an error of the write, not the end of the program.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    return flownav::run_regress_app({argv, argv + argc}, std::cout, std::cerr);
}
