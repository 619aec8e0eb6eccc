#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "temporary_folder.h"

namespace flownav::testing {
namespace {

const std::filesystem::path datasets = FLOWNAV_DATASETS;

/// The command line in the data set's read-me that created it.
std::string documented_command() {
    std::istringstream text(bytes_of(datasets / "README.md"));
    for (std::string line; std::getline(text, line);) {
        const std::size_t at = line.find("flownav-make-scene corridor ");
        if (at != std::string::npos) return line.substr(at);
    }
    return {};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(Dataset, CorridorIsAtMostTwoMegabytes) {
    EXPECT_GT(std::filesystem::file_size(datasets / "corridor.rawlog"), 500000U);
    EXPECT_LE(std::filesystem::file_size(datasets / "corridor.rawlog"), 1900000U);
}

TEST(Dataset, DocumentedCommandWritesTheCorridorByteForByte) {
    const TemporaryFolder folder;
    std::string command = documented_command();
    ASSERT_FALSE(command.empty());
    command = replaced(command, "flownav-make-scene", FLOWNAV_MAKE_SCENE);
    command = replaced(command, "share/datasets/corridor", (folder / "corridor").string());
    ASSERT_EQ(std::system((command + " > /dev/null").c_str()), 0) << command;
    for (const std::string file : {"corridor.rawlog", "corridor.gt.csv", "corridor.objects.csv"})
        EXPECT_TRUE(bytes_of(folder / file) == bytes_of(datasets / file)) << file;
}

}  // namespace
}  // namespace flownav::testing
