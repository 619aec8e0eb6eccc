#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace flownav::testing {

/// Exit status and output of a program.
struct Outcome {
    int status = 0;
    std::string out, error;
};

/// Runs the class behind a program: run_app(run_config_app, "flownav-config", {"--dump"}).
template <class App>
Outcome run_app(App app, const std::string& program, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program);
    std::ostringstream out;
    std::ostringstream error;
    const int status = app(arguments, out, error);
    return {status, out.str(), error.str()};
}

/// Creates an empty folder for the running test, below a folder named after the program.
inline std::filesystem::path folder_of_test(const std::string& program) {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / program / test->name();
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

}  // namespace flownav::testing
