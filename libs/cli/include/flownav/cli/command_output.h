#pragma once
#include <mrpt/3rdparty/tclap/CmdLine.h>

#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "flownav/flow/kernel.h"

namespace flownav::cli {

/// Prints a program's help text, its version and kernel, and errors that point to --help. Replaces TCLAP's
/// output in `command`, which may be parsed while this lives.
class CommandOutput : public TCLAP::StdOutput {
  public:
    CommandOutput(TCLAP::CmdLine& command, std::string name, std::string help, std::ostream& out,
                  std::ostream& error)
        : StdOutput(out), name_(std::move(name)), help_(std::move(help)), out_(out), error_(error) {
        delete command.getOutput();  // TCLAP forgets the one it made itself
        command.setOutput(this);
    }

    void usage(TCLAP::CmdLineInterface& /*command*/) override { out_ << help_; }

    void version(TCLAP::CmdLineInterface& command) override {
        out_ << name_ << ' ' << command.getVersion() << '\n' << "matching kernel: ";
        try {
            out_ << flow::default_kernel().name << '\n';
        } catch (const std::runtime_error& error) {
            out_ << error.what() << '\n';
        }
    }

    void failure(TCLAP::CmdLineInterface& /*command*/, TCLAP::ArgException& exception) override {
        fail(exception.error() + " (" + exception.argId() + ")");
    }

    /// Reports an error in the arguments that TCLAP does not check.
    void fail(const std::string& message) {
        failed_ = true;
        error_ << name_ << ": " << message << "\nTry " << name_ << " --help\n";
    }

    /// Whether the arguments were wrong.
    bool failed() const { return failed_; }

  private:
    std::string name_;
    std::string help_;
    std::ostream& out_;
    std::ostream& error_;
    bool failed_ = false;
};

/// Parses the arguments of a program; the first is its name. False when they are wrong, or when --help or
/// --version answered them; CommandOutput::failed() tells which.
inline bool parse_arguments(TCLAP::CmdLine& command, const std::vector<std::string>& arguments) {
    std::vector<const char*> argv;
    argv.reserve(arguments.size());
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    return command.parse(static_cast<int>(argv.size()), argv.data());
}

}  // namespace flownav::cli
