#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "flownav/regress/job.h"

namespace flownav::regress {

/// Inputs and files of a child process.
struct ChildTask {
    std::filesystem::path rawlog;
    std::string sha256;              ///< of the rawlog; checked before the replay
    std::filesystem::path program;   ///< a flownav-replay
    std::filesystem::path output;    ///< folder of the results
    std::filesystem::path config;    ///< ini
    std::filesystem::path messages;  ///< file for its standard error
    int lock = -1;                   ///< descriptor that stays open in the child
};

/// Starts a process in its own group that checks the rawlog's sha256 and becomes the replay. It exits with
/// flownav-replay's status for bad usage when the rawlog cannot be read or its sha256 differs, and it is
/// killed when this process ends. Throws std::system_error when no process can be started.
pid_t start_child(const ChildTask& task);

/// Sends a signal to the whole group of a child.
void signal_child(pid_t child, int signal);

/// Describes the end of a child by the state of waitpid(): "ended with status 2", "was ended by signal 11
/// (Segmentation fault)".
std::string describe_end(int state);

/// The last lines of a file, at most 2000 bytes.
std::string tail_of(const std::filesystem::path& file);

}  // namespace flownav::regress
