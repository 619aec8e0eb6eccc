#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "flownav/regress/job.h"

namespace flownav::regress {

/// What a child process shall do.
struct ChildTask {
    std::filesystem::path rawlog;
    std::string sha256;              ///< of the rawlog, checked first
    std::filesystem::path program;   ///< a flownav-replay
    std::filesystem::path output;    ///< its folder
    std::filesystem::path config;    ///< its ini
    std::filesystem::path messages;  ///< takes what it says on the standard error
    int lock = -1;                   ///< stays open in it
};

/// Starts a process of its own group that checks the rawlog's sha256 and becomes the replay; it exits with
/// flownav-replay's status for bad usage when the rawlog cannot be read or is another one. It does not
/// outlive this process. Throws std::system_error when there can be no more processes.
pid_t start_child(const ChildTask& task);

/// Sends a signal to the whole group of a child.
void signal_child(pid_t child, int signal);

/// How a child ended, from the state that waitpid() gives: "ended with status 2", "was ended by signal 11
/// (Segmentation fault)".
std::string describe_end(int state);

/// The last lines of a file, at most 2000 bytes.
std::string tail_of(const std::filesystem::path& file);

}  // namespace flownav::regress
