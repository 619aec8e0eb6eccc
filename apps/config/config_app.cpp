#include "config_app.h"

#include <ostream>

#include "flownav/cli/command_output.h"
#include "flownav/cli/exit_status.h"
#include "flownav/config/config.h"
#include "flownav/core/version.h"

namespace flownav {
namespace {

constexpr int usage_status = cli::exit_code(cli::ExitStatus::Usage);

constexpr auto help = R"(Prints, checks and documents the configuration of flownav.

flownav-config --dump | --check FILE.ini | --doc [--keys everyday|all]

  --dump              print the keys with their defaults and meanings, as an ini
  --check FILE.ini    say whether FILE.ini can be used, and if not: line, key, value and what is allowed
  --doc               print the keys as a table in markdown
  --keys everyday|all of --dump and --doc: the 30 keys that most users set, or all (default)
  --help, --version   print this text, or the version, and exit

Exit status:
  0  fine
  1  bad usage, or a configuration that cannot be used
)";

int check(const std::string& file, std::ostream& out, std::ostream& error) {
    try {
        config::Config config;
        config::load_config_file(config, file);
    } catch (const config::ConfigError& exception) {
        error << "flownav-config: " << exception.what() << '\n';
        return usage_status;
    }
    out << file << ": fine\n";
    return 0;
}

std::string text_of(bool dump, config::KeySet keys) {
    return dump ? config::dump_config(config::Config{}, keys) : config::document_config(keys);
}

}  // namespace

int run_config_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error) {
    TCLAP::CmdLine command("", ' ', version());
    cli::CommandOutput output(command, "flownav-config", help, out, error);
    TCLAP::SwitchArg dump("", "dump", "", command);
    TCLAP::ValueArg<std::string> file("", "check", "", false, "", "FILE.ini", command);
    TCLAP::SwitchArg doc("", "doc", "", command);
    TCLAP::ValueArg<std::string> keys("", "keys", "", false, "all", "everyday|all", command);

    if (!cli::parse_arguments(command, arguments)) return output.failed() ? usage_status : 0;
    if (dump.isSet() + file.isSet() + doc.isSet() != 1) {
        output.fail("give one of --dump, --check FILE.ini, --doc");
        return usage_status;
    }
    const bool everyday = keys.getValue() == "everyday";
    if ((!everyday && keys.getValue() != "all") || (keys.isSet() && file.isSet())) {
        output.fail("--keys everyday or --keys all, with --dump or --doc");
        return 1;
    }
    if (file.isSet()) return check(file.getValue(), out, error);
    out << text_of(dump.isSet(), everyday ? config::KeySet::Everyday : config::KeySet::All);
    return 0;
}

}  // namespace flownav
