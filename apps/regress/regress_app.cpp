#include "regress_app.h"

#include <cstdlib>
#include <filesystem>

#include "flownav/cli/usage_error.h"
#include "flownav/config/config.h"
#include "flownav/io/output_file.h"
#include "flownav/regress/commands.h"
#include "flownav/regress/exit_status.h"

namespace flownav {

namespace {

std::optional<std::string> environment(const char* name) {
    const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): there is one thread
    return value == nullptr ? std::nullopt : std::optional<std::string>(value);
}

int run_command(const regress::Options& options, std::ostream& out, std::ostream& error) {
    if (options.command == "manifest") return regress::run_manifest(options, out);
    if (options.command == "run") return regress::run_run(options, out, error);
    if (options.command == "merge") return regress::run_merge(options, out, error);
    if (options.command == "check") return regress::run_check(options, out);
    if (options.command == "accept") return regress::run_accept(options, out);
    if (options.command == "compare") return regress::run_compare(options, out);
    return regress::run_sweep(options, out, error);
}

}  // namespace

int run_regress_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error) {
    const auto fail = [&error](const std::exception& exception, int status) {
        error << "flownav-regress: " << exception.what() << '\n';
        return status;
    };
    try {
        int status = regress::exit_fine;
        const auto options = regress::parse_options(arguments, environment, out, error, status);
        return options ? run_command(*options, out, error) : status;
    } catch (const cli::UsageError& exception) {
        return fail(exception, regress::exit_usage);
    } catch (const config::ConfigError& exception) {
        return fail(exception, regress::exit_usage);
    } catch (const io::OutputError& exception) {
        return fail(exception, regress::exit_try_again);
    } catch (const std::filesystem::filesystem_error& exception) {
        return fail(exception, regress::exit_try_again);
    }
}

}  // namespace flownav
