#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <system_error>

#include "flownav/cli/usage_error.h"
#include "flownav/regress/job.h"
#include "flownav/regress/sha256.h"

namespace flownav::regress {

namespace fs = std::filesystem;

namespace {

constexpr auto name = "flownav-replay";

bool can_be_started(const fs::path& file) {
    return fs::is_regular_file(file) && access(file.c_str(), X_OK) == 0;
}

std::vector<fs::path> candidates() {
    std::error_code error;
    const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
    std::vector<fs::path> files = {here / name, here.parent_path() / "replay" / name};
    const char* const search = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): there is one thread
    std::istringstream folders(search == nullptr ? "" : search);
    for (std::string folder; std::getline(folders, folder, ':');) files.push_back(fs::path(folder) / name);
    return files;
}

fs::path find_file(const std::string& program) {
    if (!program.empty()) {
        if (!can_be_started(program))
            throw cli::UsageError("--program " + program + ": no program that can be started");
        return fs::canonical(program);
    }
    for (const fs::path& file : candidates())
        if (can_be_started(file)) return fs::canonical(file);
    throw cli::UsageError("there is no flownav-replay beside this program or in PATH: give --program");
}

std::string quoted(const std::string& word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

/// Output of `file --version`, in one line.
std::string version_of(const fs::path& file) {
    struct Close {
        void operator()(std::FILE* pipe) const { pclose(pipe); }
    };
    const std::string command = quoted(file) + " --version </dev/null 2>/dev/null";
    const std::unique_ptr<std::FILE, Close> pipe(popen(command.c_str(), "re"));
    std::array<char, 200> line{};
    if (!pipe || std::fgets(line.data(), line.size(), pipe.get()) == nullptr)
        throw cli::UsageError(file.string() + " does not tell its --version: is it a flownav-replay?");
    std::string version = line.data();
    version.erase(version.find_last_not_of(" \n") + 1);
    return version;
}

}  // namespace

ReplayProgram find_replay_program(const std::string& program) {
    const fs::path file = find_file(program);
    return {file, version_of(file), sha256_of_file(file)};
}

}  // namespace flownav::regress
