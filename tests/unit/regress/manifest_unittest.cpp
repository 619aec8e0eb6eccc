#include "flownav/regress/manifest.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app_runs.h"
#include "flownav/cli/usage_error.h"
#include "flownav/regress/sha256.h"

namespace flownav::regress {
namespace {

const std::string sha_a(64, 'a');
const std::string sha_b(64, 'b');

std::string message_of(const std::string& text) {
    try {
        parse_manifest(text, "list");
    } catch (const cli::UsageError& error) {
        return error.what();
    }
    return "";
}

void expect_refused(const std::string& text, const std::vector<std::string>& words) {
    const std::string message = message_of(text);
    for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << message;
}

TEST(Manifest, ALineIsARawlog) {
    const Manifest manifest = parse_manifest(
        "# comment\n\none drives/one.rawlog " + sha_a + "\n  two   /abs/two.rawlog.gz " + sha_b, "list");
    ASSERT_EQ(manifest.size(), 2U);
    EXPECT_EQ(manifest[0].id, "one");
    EXPECT_EQ(manifest[0].rawlog, "drives/one.rawlog");
    EXPECT_EQ(manifest[0].sha256, sha_a);
    EXPECT_TRUE(manifest[0].config.empty());
    EXPECT_EQ(manifest[1].rawlog, "/abs/two.rawlog.gz");
}

TEST(Manifest, TabsAllowBlanksInPaths) {
    const Manifest manifest = parse_manifest("one\tmy drives/a b.rawlog\t" + sha_a + "\r\n", "list");
    EXPECT_EQ(manifest.at(0).rawlog, "my drives/a b.rawlog");
}

TEST(Manifest, ARawlogMayHaveSettingsOfItsOwn) {
    const Manifest manifest = parse_manifest(
        "one a.rawlog " + sha_a + " config=kitti.ini camera.height_m=1.65 flow.blocks=200\n", "list");
    EXPECT_EQ(manifest.at(0).config, "kitti.ini");
    EXPECT_EQ(manifest.at(0).settings, (std::vector<std::string>{"camera.height_m=1.65", "flow.blocks=200"}));
}

TEST(Manifest, BadLinesAreRefusedWithTheirNumber) {
    expect_refused("one a.rawlog " + sha_a + "\ntwo b.rawlog\n", {"list, line 2", "2 field(s)", "sha256"});
    expect_refused("a/b a.rawlog " + sha_a, {"line 1", "'a/b'", "file name"});
    expect_refused("../x a.rawlog " + sha_a, {"'../x'"});
    expect_refused(".hidden a.rawlog " + sha_a, {"'.hidden'", "not beginning with '.'"});
    expect_refused("one a.rawlog 12ab", {"sha256 '12ab'", "64 hexadecimal digits"});
    expect_refused("one a.rawlog " + std::string(64, 'A'), {"lower case"});
    expect_refused("one a " + sha_a + "\none b " + sha_b, {"line 2", "'one' stands in line 1 already"});
    expect_refused("one a.rawlog " + sha_a + " fast", {"'fast'", "section.key=value"});
    expect_refused("# nothing\n", {"no rawlog in it"});
}

TEST(Manifest, AFileThatIsNotThereIsNamed) {
    EXPECT_THROW(read_manifest("/nowhere/manifest"), cli::UsageError);
    EXPECT_THROW(read_manifest("/"), cli::UsageError);
}

class ManifestOfFolder : public ::testing::Test {
  protected:
    std::filesystem::path put(const std::string& name, const std::string& content) const {
        const std::filesystem::path file = folder_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file) << content;
        return file;
    }
    std::filesystem::path folder_ = testing::folder_of_test("manifest");
};

TEST_F(ManifestOfFolder, EveryRawlogBelowItHasALineAndAnIdentifier) {
    put("day 2/b.rawlog", "bee");
    put("a.rawlog.gz", "a");
    put("notes.txt", "none");
    const Manifest manifest = parse_manifest(manifest_of_folder(folder_, folder_.parent_path()), "list");
    ASSERT_EQ(manifest.size(), 2U);
    EXPECT_EQ(manifest[0].id, "a");
    EXPECT_EQ(manifest[1].id, "day-2-b");
    EXPECT_EQ(manifest[1].rawlog, folder_.filename() / "day 2/b.rawlog");
    EXPECT_EQ(manifest[1].sha256, sha256_of_text("bee"));
}

TEST_F(ManifestOfFolder, WhatWouldBeAmbiguousIsRefused) {
    EXPECT_THROW(manifest_of_folder(folder_, folder_), cli::UsageError);
    put("a-b.rawlog", "1");
    put("a/b.rawlog", "2");
    EXPECT_THROW(manifest_of_folder(folder_, folder_), cli::UsageError);
}

TEST(Sha256, IsThatOfTheStandard) {
    EXPECT_EQ(sha256_of_text("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace flownav::regress
