#include <iostream>

#include "config_app.h"

int main(int argc, char** argv) {
    const int status = flownav::run_config_app({argv, argv + argc}, std::cout, std::cerr);
    std::cout.flush();
    return std::cout ? status : 1;
}
