#include "flownav/regress/regress_options.h"

#include <mrpt/3rdparty/tclap/CmdLine.h>
#include <sched.h>

#include <algorithm>
#include <map>
#include <set>

#include "flownav/cli/command_output.h"
#include "flownav/cli/usage_error.h"
#include "flownav/core/version.h"
#include "flownav/regress/exit_status.h"
#include "regress_help.h"

namespace flownav::regress {

namespace {

using Names = std::set<std::string>;

constexpr int most_jobs = 1024;
constexpr double longest_limit_s = 7 * 24 * 3600.0;

const Names of_replays = {"root",  "shard",   "shards",     "output", "config", "set",
                          "force", "program", "time-limit", "jobs",   "keep"};

/// The options that each command knows beside --quiet.
const std::map<std::string, Names>& accepted() {
    static const auto with = [](Names names, const Names& more) {
        names.insert(more.begin(), more.end());
        return names;
    };
    static const std::map<std::string, Names> table = {
        {"manifest", {"output"}},
        {"run", with({"manifest"}, of_replays)},
        {"sweep", with({"manifest"}, of_replays)},
        {"merge", {"manifest", "output", "missing", "failed"}},
        {"check", {"manifest", "output", "expected", "junit", "any-version"}},
        {"accept", {"manifest", "output", "expected"}},
        {"compare", {"output"}},
    };
    return table;
}

/// What each command cannot do without.
const std::map<std::string, std::vector<std::string>>& needed() {
    static const std::vector<std::string> both = {"manifest", "output"};
    static const std::map<std::string, std::vector<std::string>> table = {
        {"manifest", {}}, {"run", both},   {"sweep", {"manifest", "output", "set"}},
        {"merge", both},  {"check", both}, {"accept", both},
        {"compare", {}},
    };
    return table;
}

std::size_t folders_of(const std::string& command) {
    return command == "compare" ? 2 : command == "manifest" ? 1 : 0;
}

int processors() {
    cpu_set_t set;
    CPU_ZERO(&set);
    return sched_getaffinity(0, sizeof(set), &set) == 0 ? std::max(1, CPU_COUNT(&set)) : 1;
}

std::string commands() {
    std::string names;
    for (const auto& [name, options] : accepted()) names += (names.empty() ? "" : ", ") + name;
    return names;
}

/// The arguments of the command line, and what TCLAP made of them.
struct CommandLine {
    CommandLine(std::ostream& out, std::ostream& error)
        : output(cmd, "flownav-regress", regress_help, out, error) {}

    TCLAP::CmdLine cmd{"", ' ', version()};
    cli::CommandOutput output;
    TCLAP::UnlabeledMultiArg<std::string> words{"words", "", false, "COMMAND", cmd};
    TCLAP::ValueArg<std::string> manifest{"", "manifest", "", false, "", "FILE", cmd};
    TCLAP::ValueArg<std::string> root{"", "root", "", false, "", "DIR", cmd};
    TCLAP::ValueArg<std::string> folder{"", "output", "", false, "", "DIR", cmd};
    TCLAP::ValueArg<std::string> shard{"", "shard", "", false, "", "I", cmd};
    TCLAP::ValueArg<std::string> shards{"", "shards", "", false, "", "N", cmd};
    TCLAP::ValueArg<std::string> config{"", "config", "", false, "", "FILE.ini", cmd};
    TCLAP::MultiArg<std::string> settings{"", "set", "", false, "section.key=value", cmd};
    TCLAP::ValueArg<std::string> program{"", "program", "", false, "", "FILE", cmd};
    TCLAP::ValueArg<double> time_limit{"", "time-limit", "", false, 1800.0, "S", cmd};
    TCLAP::ValueArg<int> jobs{"", "jobs", "", false, 0, "N", cmd};
    TCLAP::ValueArg<std::string> keep{"", "keep", "", false, "", "all|figures", cmd};
    TCLAP::SwitchArg force{"", "force", "", cmd};
    TCLAP::ValueArg<std::string> expected{"", "expected", "", false, "", "FILE.json", cmd};
    TCLAP::ValueArg<std::string> junit{"", "junit", "", false, "", "FILE.xml", cmd};
    TCLAP::SwitchArg any_version{"", "any-version", "", cmd};
    TCLAP::SwitchArg missing{"", "missing", "", cmd};
    TCLAP::SwitchArg failed{"", "failed", "", cmd};
    TCLAP::SwitchArg quiet{"", "quiet", "", cmd};
};

void check_words(const std::vector<std::string>& words) {
    if (words.empty()) throw cli::UsageError("needs a command: " + commands());
    if (accepted().count(words[0]) == 0)
        throw cli::UsageError("unknown command '" + words[0] + "': must be one of " + commands());
    for (const std::string& word : words)
        if (word.rfind('-', 0) == 0) throw cli::UsageError("unknown argument " + word);  // TCLAP lets it pass
    const std::size_t folders = folders_of(words[0]);
    if (words.size() > folders + 1) throw cli::UsageError("unknown argument " + words[folders + 1]);
    if (words.size() < folders + 1)
        throw cli::UsageError(words[0] + " needs " + (folders == 2 ? "two folders of results" : "a folder"));
}

void check_options(TCLAP::CmdLine& cmd, const std::string& command) {
    const Names& known = accepted().at(command);
    Names set;
    for (const TCLAP::Arg* arg : cmd.getArgList())
        if (arg->isSet()) set.insert(arg->getName());
    for (const std::string& name : set)
        if (known.count(name) == 0 && name != "quiet" && name != "words")
            throw cli::UsageError("--" + name + " is no option of " + command);
    for (const std::string& name : needed().at(command))
        if (set.count(name) == 0) throw cli::UsageError(command + " needs --" + name);
}

Keep keep_of(const std::string& word, const std::string& command) {
    if (word.empty()) return command == "sweep" ? Keep::FiguresOnly : Keep::All;
    if (word == "all") return Keep::All;
    if (word == "figures") return Keep::FiguresOnly;
    throw cli::UsageError("--keep " + word + ": must be all or figures");
}

RunOptions run_options(CommandLine& line, const std::string& command, bool is_shard) {
    RunOptions run;
    run.time_limit_s = line.time_limit.getValue();
    if (!(run.time_limit_s > 0.0 && run.time_limit_s <= longest_limit_s))
        throw cli::UsageError("--time-limit: must be more than 0 and at most 604800 s");
    run.jobs = line.jobs.isSet() ? line.jobs.getValue() : is_shard ? 1 : processors();
    if (run.jobs < 1 || run.jobs > most_jobs)
        throw cli::UsageError("--jobs " + std::to_string(run.jobs) + ": must be 1.." +
                              std::to_string(most_jobs));
    run.keep = keep_of(line.keep.getValue(), command);
    run.force = line.force.getValue();
    return run;
}

std::filesystem::path root_of(const std::string& given, const std::filesystem::path& manifest) {
    if (given.empty()) return manifest.parent_path();
    if (!std::filesystem::is_directory(given)) throw cli::UsageError("--root " + given + ": no such folder");
    return given;
}

Options options_of(CommandLine& line, const Environment& environment) {
    const std::vector<std::string>& words = line.words.getValue();
    check_words(words);
    Options options;
    options.command = words.front();
    options.folders.assign(words.begin() + 1, words.end());
    check_options(line.cmd, options.command);
    options.manifest = line.manifest.getValue();
    options.root = root_of(line.root.getValue(), options.manifest);
    options.output = line.folder.getValue();
    if (options.command == "run" || options.command == "sweep")
        options.shard = find_shard(line.shard.getValue(), line.shards.getValue(), environment);
    options.config = line.config.getValue();
    options.program = line.program.getValue();
    options.settings = line.settings.getValue();
    options.run = run_options(line, options.command, options.shard.has_value());
    options.expected = line.expected.isSet() ? std::filesystem::path(line.expected.getValue())
                                             : options.manifest.parent_path() / "expected.json";
    options.junit = line.junit.getValue();
    options.any_version = line.any_version.getValue();
    options.missing = line.missing.getValue();
    options.failed = line.failed.getValue();
    options.quiet = line.quiet.getValue();
    return options;
}

}  // namespace

std::optional<Options> parse_options(const std::vector<std::string>& arguments,
                                     const Environment& environment, std::ostream& out, std::ostream& error,
                                     int& status) {
    CommandLine line(out, error);
    if (!cli::parse_arguments(line.cmd, arguments)) {
        status = line.output.failed() ? exit_usage : exit_fine;
        return std::nullopt;
    }
    return options_of(line, environment);
}

}  // namespace flownav::regress
