#include <csignal>
#include <iostream>

#include "import_app.h"

int main(int argc, char** argv) {
    // Makes a closed pipe or a file size limit an error of the write instead of a fatal signal.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    return flownav::run_import_app({argv, argv + argc}, std::cout, std::cerr);
}
