#include <flownav/replay/rawlog_reader.h>
#include <flownav/sensor/config.h>

#include <cstdio>

int main(int argc, char** argv) {
    flownav::Config config;
    if (argc > 1) flownav::load_config_file(config, argv[1]);
    std::fputs(flownav::dump_config(config).c_str(), stdout);
    try {
        flownav::RawlogReader reader("no_such_file.rawlog");
    } catch (const flownav::InputError&) {
        return 0;
    }
    return 1;
}
