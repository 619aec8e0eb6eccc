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

/// Runs a program without terminal and without input, and waits for it. `scratch` takes its output meanwhile.
Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const std::filesystem::path& scratch);

}  // namespace flownav::testing
