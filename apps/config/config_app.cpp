#include "config_app.h"

#include <ostream>

#include "flownav/cli/command_output.h"
#include "flownav/config/config.h"
#include "flownav/core/version.h"

namespace flownav {
namespace {

constexpr auto help = R"(Prints, checks and documents the configuration of flownav.

flownav-config --dump | --check FILE.ini | --doc

  --dump              print every key with its default and its meaning, as an ini
  --check FILE.ini    say whether FILE.ini can be used, and if not: line, key, value and what is allowed
  --doc               print every key as a table in markdown
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
        return 1;
    }
    out << file << ": fine\n";
    return 0;
}

}  // namespace

int run_config_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error) {
    TCLAP::CmdLine command("", ' ', version());
    cli::CommandOutput output(command, "flownav-config", help, out, error);
    TCLAP::SwitchArg dump("", "dump", "", command);
    TCLAP::ValueArg<std::string> file("", "check", "", false, "", "FILE.ini", command);
    TCLAP::SwitchArg doc("", "doc", "", command);

    std::vector<const char*> argv;
    argv.reserve(arguments.size());
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    if (!command.parse(static_cast<int>(argv.size()), argv.data())) return output.failed() ? 1 : 0;
    if (dump.isSet() + file.isSet() + doc.isSet() != 1) {
        output.fail("give one of --dump, --check FILE.ini, --doc");
        return 1;
    }
    if (file.isSet()) return check(file.getValue(), out, error);
    out << (dump.isSet() ? config::dump_config(config::Config{}) : config::document_config());
    return 0;
}

}  // namespace flownav
