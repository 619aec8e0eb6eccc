#include "flownav/regress/store.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app_runs.h"
#include "flownav/io/output_file.h"
#include "flownav/regress/result.h"

namespace flownav::regress {
namespace {

namespace fs = std::filesystem;

class Stored : public ::testing::Test {
  protected:
    /// A folder with a complete result of a replay.
    ScratchFolder made(const std::string& key, const char* file = result_file,
                       const std::string& more = "") const {
        ScratchFolder folder = store_.scratch("one");
        Result result;
        result.id = "one";
        result.key = key;
        io::write_file(folder.path() / file, result_text(result));
        io::write_file(folder.path() / "more", more);
        return folder;
    }
    std::string more(const char* kind) const {
        std::ifstream stream(root_ / kind / "one/more");
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    bool nothing_is_left() const { return fs::is_empty(root_ / "tmp"); }

    fs::path root_ = testing::folder_of_test("store");
    Store store_{root_};
};

TEST_F(Stored, WhatIsDoneIsKnownByItsKey) {
    EXPECT_FALSE(store_.is_done("one", "k"));
    store_.commit_done(made("k"), "one", "k", false);
    EXPECT_TRUE(store_.is_done("one", "k"));
    EXPECT_FALSE(store_.is_done("one", "other"));
    EXPECT_TRUE(nothing_is_left());
}

TEST_F(Stored, WhoComesSecondWithTheSameKeyChangesNothing) {
    store_.commit_done(made("k", result_file, "first"), "one", "k", false);
    store_.commit_done(made("k", result_file, "second"), "one", "k", false);
    EXPECT_EQ(more("done"), "first");
    store_.commit_done(made("k", result_file, "forced"), "one", "k", true);
    EXPECT_EQ(more("done"), "forced");
    EXPECT_TRUE(nothing_is_left());
}

TEST_F(Stored, AResultWithAnotherKeyGivesWay) {
    store_.commit_done(made("old", result_file, "old"), "one", "old", false);
    store_.commit_done(made("new", result_file, "new"), "one", "new", false);
    EXPECT_EQ(more("done"), "new");
}

TEST_F(Stored, ADamagedResultGivesWay) {
    fs::create_directories(root_ / "done/one");
    std::ofstream(root_ / "done/one" / result_file) << "{\"id\": \"o";
    EXPECT_FALSE(store_.is_done("one", "k"));
    store_.commit_done(made("k"), "one", "k", false);
    EXPECT_TRUE(store_.is_done("one", "k"));
}

TEST_F(Stored, SuccessForgetsTheFailureBefore) {
    store_.commit_failed(made("k", failure_file), "one", "k");
    EXPECT_TRUE(fs::exists(root_ / "failed/one" / failure_file));
    store_.commit_done(made("k"), "one", "k", false);
    EXPECT_FALSE(fs::exists(root_ / "failed/one"));
}

TEST_F(Stored, FailureForgetsASuccessOfSomethingElseOnly) {
    store_.commit_done(made("k"), "one", "k", false);
    store_.commit_failed(made("k", failure_file), "one", "k");
    EXPECT_TRUE(store_.is_done("one", "k"));
    EXPECT_FALSE(fs::exists(root_ / "failed/one"));
    store_.commit_failed(made("other", failure_file), "one", "other");
    EXPECT_FALSE(fs::exists(root_ / "done/one"));
    EXPECT_TRUE(fs::exists(root_ / "failed/one"));
}

TEST_F(Stored, LeftOversGoUnlessSomebodyUsesThem) {
    const ScratchFolder used = store_.scratch("one");
    fs::create_directories(root_ / "tmp/two.killed");
    store_.remove_left_overs();
    EXPECT_TRUE(fs::exists(used.path()));
    EXPECT_FALSE(fs::exists(root_ / "tmp/two.killed"));
}

TEST_F(Stored, WhereNothingCanBeWrittenItSaysSo) {
    std::ofstream(root_ / "file") << "x";
    EXPECT_THROW(Store(root_ / "file/below"), io::OutputError);
}

}  // namespace
}  // namespace flownav::regress
