#include "config_app.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "app_runs.h"
#include "flownav/config/config.h"
#include "flownav/core/version.h"
#include "flownav/flow/kernel.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;

using testing::Outcome;

Outcome run(const std::vector<std::string>& arguments) {
    return testing::run_app(run_config_app, "flownav-config", arguments);
}

std::string content(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

TEST(ConfigApp, DumpIsTheDefaultConfigurationAndTheFileInTheTree) {
    const Outcome dump = run({"--dump"});
    EXPECT_EQ(dump.status, 0);
    EXPECT_EQ(dump.out, config::dump_config(config::Config{}));
    EXPECT_EQ(dump.out, content(fs::path(FLOWNAV_INI_DIR) / "default.ini"))
        << "run: flownav-config --dump > ini/default.ini";
}

TEST(ConfigApp, EveryIniInTheTreeIsFine) {
    int files = 0;
    for (const auto& entry : fs::directory_iterator(FLOWNAV_INI_DIR)) {
        const Outcome check = run({"--check", entry.path().string()});
        EXPECT_EQ(check.status, 0) << check.error;
        ++files;
    }
    EXPECT_GE(files, 3);
}

TEST(ConfigApp, ReadyInisHoldOnlyWhatDiffersFromTheDefaults) {
    for (const auto& entry : fs::directory_iterator(FLOWNAV_INI_DIR)) {
        if (entry.path().filename() == "default.ini") continue;
        const std::string text = content(entry.path());
        for (const config::ConfigKey& key : config::config_keys()) {
            EXPECT_EQ(text.find("\n" + key.name + " = " + key.default_value + "\n"), std::string::npos)
                << entry.path() << ": " << key.name;
        }
    }
}

TEST(ConfigApp, CheckNamesWhatIsWrongAndExitsWithOne) {
    const fs::path file = fs::path(::testing::TempDir()) / "flownav_config_app_check.ini";
    std::ofstream(file) << "[camera]\nheight_m = 0\n";
    const Outcome check = run({"--check", file.string()});
    EXPECT_EQ(check.status, 1);
    EXPECT_EQ(check.out, "");
    EXPECT_EQ(check.error,
              "flownav-config: " + file.string() +
                  ":2: camera.height_m = 0: is out of range; allowed: 0.01 .. 20, or recorded (m)\n");
    fs::remove(file);
    EXPECT_NE(run({"--check", file.string()}).error.find("no such file"), std::string::npos);
}

TEST(ConfigApp, KeysChoosesBetweenTheEverydayKeysAndAll) {
    using config::KeySet;
    EXPECT_EQ(run({"--dump", "--keys", "everyday"}).out, dump_config(config::Config{}, KeySet::Everyday));
    EXPECT_EQ(run({"--doc", "--keys", "everyday"}).out, config::document_config(KeySet::Everyday));
    EXPECT_EQ(run({"--dump", "--keys", "all"}).out, run({"--dump"}).out);
    EXPECT_LT(run({"--dump", "--keys", "everyday"}).out.size(), run({"--dump"}).out.size());
}

TEST(ConfigApp, DocIsTheTableOfKeys) {
    EXPECT_EQ(run({"--doc"}).out, config::document_config());
}

TEST(ConfigApp, HelpAndVersionGoToStandardOutput) {
    const Outcome help = run({"--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_NE(help.out.find("Exit status"), std::string::npos);
    EXPECT_EQ(run({"--version"}).out, std::string("flownav-config ") + version() +
                                          "\nmatching kernel: " + flow::default_kernel().name + "\n");
}

TEST(ConfigApp, WrongArgumentsExitWithOneAndPointToHelp) {
    const std::vector<std::vector<std::string>> wrong = {{},
                                                         {"--dump", "--doc"},
                                                         {"--check"},
                                                         {"--nonsense"},
                                                         {"file.ini"},
                                                         {"--dump", "--check", "a.ini"},
                                                         {"--dump", "--keys", "few"},
                                                         {"--check", "a.ini", "--keys", "all"}};
    for (const auto& arguments : wrong) {
        const Outcome result = run(arguments);
        EXPECT_EQ(result.status, 1);
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.error.find("--help"), std::string::npos);
    }
}

}  // namespace
}  // namespace flownav
