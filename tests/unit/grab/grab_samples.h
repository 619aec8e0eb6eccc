#pragma once
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace flownav::testing {

using Bytes = std::vector<std::uint8_t>;

inline Bytes bytes_of(const std::string& text) {
    return {text.begin(), text.end()};
}

/// Incompressible bytes.
inline Bytes noise(std::size_t count, std::uint32_t seed) {
    Bytes bytes(count);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>((seed = seed * 1664525U + 1013904223U) >> 24U);
    return bytes;
}

/// Unpacks a gz file; fails the test when it is damaged or ends inside a member.
inline std::string unpacked(const std::filesystem::path& file) {
    gzFile gz = gzopen(file.c_str(), "rb");
    EXPECT_NE(gz, nullptr) << file;
    std::string text;
    char buffer[4096];
    int count = 0;
    while ((count = gzread(gz, buffer, sizeof(buffer))) > 0)
        text.append(buffer, static_cast<std::size_t>(count));
    EXPECT_EQ(count, 0) << file;
    EXPECT_EQ(gzclose(gz), Z_OK) << file;
    return text;
}

inline std::filesystem::path grab_test_folder() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::filesystem::path folder =
        std::filesystem::path(::testing::TempDir()) / "unit_grab" / test->test_suite_name() / test->name();
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

}  // namespace flownav::testing
