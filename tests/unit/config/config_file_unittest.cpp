#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "flownav/config/config.h"

namespace flownav::config {
namespace {

namespace fs = std::filesystem;

class ConfigFile : public ::testing::Test {
  protected:
    void SetUp() override {
        const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
        folder_ = fs::path(::testing::TempDir()) / ("flownav_config_file_" + test);
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string write(const std::string& text) const {
        const fs::path file = folder_ / "test.ini";
        std::ofstream(file, std::ios::binary) << text;
        return file.string();
    }

    Config load(const std::string& text) const {
        Config config;
        load_config_file(config, write(text));
        return config;
    }

    /// Error message of the text, without the folder's name.
    std::string error_of(const std::string& text) const {
        try {
            load(text);
        } catch (const ConfigError& error) {
            const std::string what = error.what();
            const std::string start = folder_.string() + "/";
            EXPECT_EQ(what.find(start), 0U) << what;
            return what.substr(start.size());
        }
        return "";
    }

    fs::path folder_;
};

TEST_F(ConfigFile, DumpReadsBackAsTheSameConfiguration) {
    Config config;
    for (const auto& [key, value] : {std::pair{"camera.height_m", "0.1234567890123"},
                                     {"camera.distortion", "0.1 -0.2 0.003 0 1e-05"},
                                     {"camera.camera_label", "front left"},
                                     {"flow.subpixel", "none"},
                                     {"motion.cycle_images", "5"},
                                     {"obstacles.lambda_px", "0.7"},
                                     {"map.memory_s", "3.25"}})
        set_config_value(config, key, value);
    EXPECT_EQ(dump_config(load(dump_config(config))), dump_config(config));
}

TEST_F(ConfigFile, TheChangesAreTheKeysThatAreNotTheDefaults) {
    EXPECT_EQ(dump_changes(Config{}), "");
    Config config;
    set_config_value(config, "obstacles.tau_px", "1.375");
    set_config_value(config, "flow.blocks", "200");
    set_config_value(config, "obstacles.neighbours", "1");
    const std::string changes = "[flow]\nblocks = 200\n[obstacles]\ntau_px = 1.375\nneighbours = 1\n";
    EXPECT_EQ(dump_changes(config), changes);
    EXPECT_EQ(dump_config(load(changes)), dump_config(config));
}

TEST_F(ConfigFile, KeysThatAreNotThereKeepTheirValues) {
    Config config;
    set_config_value(config, "flow.blocks", "100");
    load_config_file(config, write("[map]\nresolution_m = 0.2\n"));
    EXPECT_EQ(config.pipeline.flow.blocks, 100);
    EXPECT_EQ(config.map.resolution_m, 0.2);
}

TEST_F(ConfigFile, MrptConventionsHold) {
    const Config config = load(
        "\xEF\xBB\xBF# comment\n; comment\n// comment = no key\n@define HEIGHT 1.5\n"
        "[camera]  // the camera\r\n  height_m=${HEIGHT}\t// metres\n\tfx_px = $eval{100*2}\n"
        "distortion = 0.1 0.2 \\\n 0 0 0\n[flow]\nblocks = 100\n[camera]\npitch_deg = 10\n");
    EXPECT_EQ(config.camera.height_m, 1.5);
    EXPECT_EQ(config.camera.fx_px, 200.0);
    EXPECT_EQ(config.camera.distortion, (std::array<double, 5>{0.1, 0.2, 0, 0, 0}));
    EXPECT_EQ(config.camera.pitch_deg, 10.0);
    EXPECT_EQ(config.pipeline.flow.blocks, 100);
}

TEST_F(ConfigFile, AnEmptyFileChangesNothing) {
    EXPECT_EQ(dump_config(load("")), dump_config(Config{}));
    EXPECT_EQ(dump_config(load("\n\n# nothing\n[camera]\n")), dump_config(Config{}));
}

TEST_F(ConfigFile, TheFileItselfIsNeverWritten) {
    const std::string text = "[camera]\nheight_m=1   // as it was\n\n\n[camera]\n";
    const std::string file = write(text);
    Config config;
    load_config_file(config, file);
    std::stringstream content;
    content << std::ifstream(file).rdbuf();
    EXPECT_EQ(content.str(), text);
}

TEST_F(ConfigFile, ErrorsNameFileLineKeyValueAndRange) {
    EXPECT_EQ(error_of("[camera]\nheight_m = -1\n"),
              "test.ini:2: camera.height_m = -1: is out of range; allowed: 0.01 .. 20, or recorded (m)");
    EXPECT_EQ(
        error_of("[camera]\nheight_m = nan\n"),
        "test.ini:2: camera.height_m = nan: is not a finite number; allowed: 0.01 .. 20, or recorded (m)");
    EXPECT_EQ(error_of("[flow]\n\nblock = 3\n"),
              "test.ini:3: unknown key flow.block; the nearest known key is flow.blocks "
              "(flownav-config --doc lists all)");
    EXPECT_EQ(error_of("[flow]\nblocks = 20 # few\n"),
              "test.ini:2: flow.blocks = 20 # few: is not a whole number; allowed: 16 .. 2000; a comment "
              "behind a value "
              "starts with //");
}

TEST_F(ConfigFile, ContinuedLinesDoNotShiftLineNumbers) {
    EXPECT_EQ(error_of("[camera]\ndistortion = 0 0 \\\n 0 0 0\nheight_m = -1\n").find("test.ini:4: "), 0U);
}

TEST_F(ConfigFile, AKeySetTwiceIsAnErrorEvenInAnotherCase) {
    EXPECT_EQ(error_of("[flow]\nblocks = 20\n[map]\nsize_m = 5\n[flow]\nblocks = 20\n"),
              "test.ini:6: key flow.blocks is set a second time; first in line 2");
    EXPECT_EQ(error_of("[flow]\nblocks = 20\n[Flow]\nBLOCKS = 30\n"),
              "test.ini:4: key Flow.BLOCKS is set a second time; first in line 2");
}

TEST_F(ConfigFile, MalformedLinesAreNotPassedOver) {
    EXPECT_EQ(error_of("[flow]\nblocks 20\n"),
              "test.ini:2: malformed line, expected [section], name = value or a comment: blocks 20");
    EXPECT_EQ(error_of("[flow\nblocks = 20\n"), "test.ini:1: malformed section line: [flow");
    EXPECT_EQ(error_of("[flow] blocks = 20\n"), "test.ini:1: malformed section line: [flow] blocks = 20");
    EXPECT_EQ(error_of("[flow]\n= 20\n").find("test.ini:2: malformed line"), 0U);
    EXPECT_EQ(error_of("@include other.ini\n").find("test.ini:1: malformed line"), 0U);
    EXPECT_EQ(error_of("blocks = 20\n"), "test.ini:1: key blocks stands before the first [section]");
    EXPECT_EQ(error_of("[camera]\nheight_m =\n").find("test.ini:2: camera.height_m = : is not a number"), 0U);
    EXPECT_EQ(error_of(std::string("\x89PNG\r\n\x1a\n\0\0", 10)), "test.ini: is not a text file");
}

TEST_F(ConfigFile, UndefinedVariablesAndBrokenFormulasAreNamed) {
    EXPECT_NE(error_of("[camera]\nheight_m = ${HIGH}\n").find("HIGH"), std::string::npos);
    const std::string error = error_of("[camera]\nheight_m = $eval{2+}\n");
    EXPECT_NE(error.find("2+"), std::string::npos) << error;
    EXPECT_EQ(error.find("backtrace"), std::string::npos) << error;
}

TEST_F(ConfigFile, AnErrorLeavesTheConfigurationAsItWas) {
    Config config;
    EXPECT_THROW(load_config_file(config, write("[flow]\nblocks = 20\nconfidence_min = 7\n")), ConfigError);
    EXPECT_EQ(dump_config(config), dump_config(Config{}));
}

TEST_F(ConfigFile, MissingFilesAndFoldersAreNamed) {
    Config config;
    const auto said = [&](const fs::path& path) -> std::string {
        try {
            load_config_file(config, path.string());
        } catch (const ConfigError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(said(folder_ / "none.ini"), (folder_ / "none.ini").string() + ": no such file");
    EXPECT_EQ(said(folder_), folder_.string() + ": is a folder, expected an ini file");
    EXPECT_NE(said(write("x") + "/below.ini"), "");
}

}  // namespace
}  // namespace flownav::config
