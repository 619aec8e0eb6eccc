#include "child.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>

namespace flownav::testing {

namespace {

[[noreturn]] void become(const std::string& program, const std::vector<char*>& argv, const char* log,
                         std::uint64_t file_bytes_max) {
    const int file = open(log, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0644);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    close(STDIN_FILENO);
    const rlimit limit{file_bytes_max, file_bytes_max};
    if (file_bytes_max > 0) setrlimit(RLIMIT_FSIZE, &limit);
    execv(program.c_str(), argv.data());
    _exit(127);
}

int meaning(int state) {
    return WIFEXITED(state) ? WEXITSTATUS(state) : -WTERMSIG(state);
}

}  // namespace

Child::Child(const std::string& program, const std::vector<std::string>& arguments, std::filesystem::path log,
             std::uint64_t file_bytes_max)
    : log_(std::move(log)) {
    std::vector<char*> argv = {const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    process_ = fork();
    if (process_ == 0) become(program, argv, log_.c_str(), file_bytes_max);
}

Child::~Child() {
    if (ended_) return;
    signal(SIGKILL);
    wait();
}

void Child::signal(int number) const {
    kill(process_, number);
}

bool Child::running() {
    int state = 0;
    if (!ended_ && waitpid(process_, &state, WNOHANG) == process_) {
        ended_ = true;
        status_ = meaning(state);
    }
    return !ended_;
}

int Child::wait() {
    int state = 0;
    if (!ended_ && waitpid(process_, &state, 0) == process_) {
        ended_ = true;
        status_ = meaning(state);
    }
    return status_;
}

std::string Child::log() const {
    std::ostringstream text;
    text << std::ifstream(log_).rdbuf();
    return text.str();
}

}  // namespace flownav::testing
