#include "program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace flownav::testing {

namespace {

void redirect(const char* path, int flags, int descriptor) {
    const int file = open(path, flags | O_CLOEXEC, 0644);
    dup2(file, descriptor);
}

/// A pipe without data; its reading end reaches the end of file when this object is destroyed.
class Pipe {
  public:
    Pipe() {
        if (pipe2(ends_, O_CLOEXEC) != 0) ends_[0] = ends_[1] = -1;
    }
    ~Pipe() {
        close(ends_[0]);
        close(ends_[1]);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    int reading_end() const { return ends_[0]; }

  private:
    int ends_[2] = {};
};

[[noreturn]] void become(const std::string& program, const std::vector<std::string>& arguments,
                         const std::string& out, const std::string& error, int input) {
    if (input >= 0) {
        dup2(input, STDIN_FILENO);
    } else {
        redirect("/dev/null", O_RDONLY, STDIN_FILENO);
    }
    constexpr unsigned patience_s = 300;
    alarm(patience_s);  // ends a program that hangs
    redirect(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
    redirect(error.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
    std::vector<char*> argv = {const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execv(program.c_str(), argv.data());
    _exit(127);
}

std::string text_of(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace

Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const std::filesystem::path& scratch, Input input) {
    const std::string out = scratch / "program.out";
    const std::string error = scratch / "program.err";
    const Pipe waiting;
    const pid_t child = fork();
    if (child == 0)
        become(program, arguments, out, error, input == Input::Waiting ? waiting.reading_end() : -1);
    int state = 0;
    rusage usage{};
    wait4(child, &state, 0, &usage);
    return {WIFEXITED(state) ? WEXITSTATUS(state) : -1, text_of(out), text_of(error), usage.ru_maxrss};
}

}  // namespace flownav::testing
