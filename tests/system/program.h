#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace flownav::testing {

/// Exit status and output of a program.
struct Outcome {
    int status = -1;    ///< exit status; -1 when a signal ended it
    std::string out;    ///< standard output
    std::string error;  ///< standard error
    long peak_memory_kb = 0;
};

/// Standard input of a program.
enum class Input {
    AtEnd,    ///< at its end from the start
    Waiting,  ///< a pipe that stays open and empty
};

/// Runs a program without a terminal and waits for it, five minutes at most. Its output goes through files in
/// `scratch`.
Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const std::filesystem::path& scratch, Input input = Input::AtEnd);

}  // namespace flownav::testing
