#include "flownav/regress/child.h"

#include <fcntl.h>
#include <signal.h>  // NOLINT: the C++ header has no sigset_t
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>
#include <system_error>
#include <vector>

#include "flownav/regress/sha256.h"

namespace flownav::regress {

namespace {

constexpr int bad_usage = 1;       // as in flownav-replay
constexpr int cannot_start = 127;  // as in shells
constexpr std::size_t tail_bytes = 2000;

void redirect(const char* path, int flags, int descriptor) {
    constexpr mode_t mode = 0644;
    const int file = open(path, flags | O_CLOEXEC, mode);
    if (file < 0 || dup2(file, descriptor) < 0) _exit(cannot_start);
}

void detach(pid_t parent) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(cannot_start);  // the parent has ended already
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    signal(SIGPIPE, SIG_DFL);
    signal(SIGXFSZ, SIG_DFL);
}

/// Compares the rawlog with the manifest's sha256; writes the reason to stderr when it differs.
bool is_the_rawlog(const ChildTask& task) try {
    const std::string sha256 = sha256_of_file(task.rawlog);
    if (sha256 == task.sha256) return true;
    std::cerr << task.rawlog.string() << " is not the file of the manifest: its sha256 is " << sha256
              << ", in the manifest stands " << task.sha256 << std::endl;
    return false;
} catch (const std::system_error& error) {
    std::cerr << error.what() << std::endl;
    return false;
}

[[noreturn]] void become_replay(const ChildTask& task) {
    std::vector<std::string> words = {task.program, task.rawlog, "--output", task.output,
                                      "--config",   task.config, "--quiet"};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(task.program.c_str(), arguments.data());
    std::cerr << "cannot start " << task.program.string() << ": " << std::strerror(errno) << std::endl;
    _exit(cannot_start);
}

[[noreturn]] void run_in_child(const ChildTask& task, pid_t parent) {
    detach(parent);
    redirect("/dev/null", O_RDONLY, STDIN_FILENO);
    redirect("/dev/null", O_WRONLY, STDOUT_FILENO);
    redirect(task.messages.c_str(), O_WRONLY | O_CREAT | O_APPEND, STDERR_FILENO);
    if (task.lock >= 0) fcntl(task.lock, F_SETFD, 0);
    if (!is_the_rawlog(task)) _exit(bad_usage);
    become_replay(task);
}

}  // namespace

pid_t start_child(const ChildTask& task) {
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child < 0) throw std::system_error(errno, std::generic_category(), "cannot start a process");
    if (child == 0) run_in_child(task, parent);
    setpgid(child, child);  // both processes set the group, because either may run first
    return child;
}

void signal_child(pid_t child, int signal) {
    kill(-child, signal);
}

std::string describe_end(int state) {
    if (WIFEXITED(state)) return "ended with status " + std::to_string(WEXITSTATUS(state));
    const int signal = WTERMSIG(state);
    return "was ended by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
}

std::string tail_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    std::string tail = text.str();
    if (tail.size() <= tail_bytes) return tail;
    tail.erase(0, tail.size() - tail_bytes);
    return tail.substr(tail.find('\n') + 1);
}

}  // namespace flownav::regress
