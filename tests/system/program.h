#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace flownav::testing {

/// How a program ended and what it said.
struct Outcome {
    int status = -1;    ///< exit status; -1 when a signal ended it
    std::string out;    ///< its standard output
    std::string error;  ///< its standard error
    long peak_memory_kb = 0;
};

/// What a program finds on its standard input.
enum class Input {
    AtEnd,    ///< it is at its end at once
    Waiting,  ///< a pipe that stays open and empty
};

/// Runs a program without terminal and without input, and waits for it, five minutes at most. `scratch` takes
/// its output meanwhile.
Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const std::filesystem::path& scratch, Input input = Input::AtEnd);

}  // namespace flownav::testing
