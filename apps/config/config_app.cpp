#include "config_app.h"

#include <mrpt/3rdparty/tclap/CmdLine.h>

#include <ostream>

#include "flownav/core/version.h"
#include "flownav/sensor/config.h"

namespace flownav {
namespace {

constexpr auto description =
    "Prints, checks and documents the configuration of flownav.\n"
    "Exit status: 0 fine; 1 bad usage, or a configuration that cannot be used.";

/// TCLAP's output on our streams; remembers whether the arguments were wrong.
class Output : public TCLAP::StdOutput {
  public:
    Output(std::ostream& out, std::ostream& error) : StdOutput(out), out_(out), error_(error) {}

    void version(TCLAP::CmdLineInterface& command) override {
        out_ << "flownav-config " << command.getVersion() << '\n';
    }

    void failure(TCLAP::CmdLineInterface& /*command*/, TCLAP::ArgException& exception) override {
        failed = true;
        error_ << "flownav-config: " << exception.error() << ' ' << exception.argId()
               << "\nTry flownav-config --help\n";
    }

    bool failed = false;

  private:
    std::ostream& out_;
    std::ostream& error_;
};

int check(const std::string& file, std::ostream& out, std::ostream& error) {
    try {
        Config config;
        load_config_file(config, file);
    } catch (const ConfigError& exception) {
        error << "flownav-config: " << exception.what() << '\n';
        return 1;
    }
    out << file << ": fine\n";
    return 0;
}

}  // namespace

int run_config_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error) {
    TCLAP::CmdLine command(description, ' ', version());
    Output output(out, error);
    command.setOutput(&output);
    TCLAP::SwitchArg dump("", "dump", "Print every key with its default, as an ini", command);
    TCLAP::ValueArg<std::string> file("", "check", "Check an ini file", false, "", "FILE", command);
    TCLAP::SwitchArg doc("", "doc", "Print every key as a table in markdown", command);

    std::vector<const char*> argv;
    argv.reserve(arguments.size());
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    if (!command.parse(static_cast<int>(argv.size()), argv.data())) return output.failed ? 1 : 0;
    if (dump.isSet() + file.isSet() + doc.isSet() != 1) {
        error << "flownav-config: give one of --dump, --check FILE, --doc\nTry flownav-config --help\n";
        return 1;
    }
    if (file.isSet()) return check(file.getValue(), out, error);
    out << (dump.isSet() ? dump_config(Config{}) : document_config());
    return 0;
}

}  // namespace flownav
