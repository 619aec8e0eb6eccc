#include <flownav/config/config.h>
#include <flownav/io/rawlog_reader.h>

#include <cstdio>

int main(int argc, char** argv) {
    flownav::config::Config config;
    if (argc > 1) flownav::config::load_config_file(config, argv[1]);
    std::fputs(flownav::config::dump_config(config).c_str(), stdout);
    try {
        flownav::io::RawlogReader reader("no_such_file.rawlog");
    } catch (const flownav::io::InputError&) {
        return 0;
    }
    return 1;
}
