#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "temporary_folder.h"

namespace flownav::testing {
namespace {

/// Runs the tool with its output in `said`; returns the exit status.
int run_tool(const std::string& arguments, const std::filesystem::path& said) {
    const std::string command =
        std::string(FLOWNAV_MAKE_SCENE) + ' ' + arguments + " > " + said.string() + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
}

TEST(MakeSceneTool, ListsItsKindsAndHelps) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_tool("--list", folder / "said"), 0);
    EXPECT_NE(bytes_of(folder / "said").find("corridor\n"), std::string::npos);
    EXPECT_EQ(run_tool("--help", folder / "said"), 0);
    EXPECT_NE(bytes_of(folder / "said").find("--floor"), std::string::npos);
}

TEST(MakeSceneTool, ListsAndRendersItsPresets) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_tool("--list", folder / "said"), 0);
    EXPECT_NE(bytes_of(folder / "said").find("vibration015"), std::string::npos);
    const std::string output = " --output " + (folder / "s").string();
    EXPECT_EQ(run_tool("--preset plain --seed 3 --images 2" + output, folder / "said"), 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "s.rawlog"));
    EXPECT_EQ(run_tool("--preset maze" + output, folder / "said"), 1);
    EXPECT_NE(bytes_of(folder / "said").find("maze"), std::string::npos);
}

TEST(MakeSceneTool, BadArgumentsAreStatusOneAndAreNamed) {
    const TemporaryFolder folder;
    const std::string output = " --output " + (folder / "s").string();
    EXPECT_EQ(run_tool("maze" + output, folder / "said"), 1);
    EXPECT_NE(bytes_of(folder / "said").find("maze"), std::string::npos);
    EXPECT_EQ(run_tool("corridor --images 1" + output, folder / "said"), 1);
    EXPECT_NE(bytes_of(folder / "said").find("images = 1"), std::string::npos);
    EXPECT_EQ(run_tool("corridor --floor grass" + output, folder / "said"), 1);
    EXPECT_EQ(run_tool("corridor", folder / "said"), 1);
    EXPECT_FALSE(std::filesystem::exists(folder / "s.rawlog"));
}

TEST(MakeSceneTool, UnwritableOutputIsStatusThreeAndIsNamed) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_tool("corridor --images 2 --output " + (folder / "absent" / "s").string(), folder / "said"),
              3);
    EXPECT_NE(bytes_of(folder / "said").find("absent"), std::string::npos);
}

}  // namespace
}  // namespace flownav::testing
