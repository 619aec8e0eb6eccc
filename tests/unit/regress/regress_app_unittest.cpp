#include "regress_app.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>  // NOLINT: the C++ header has no kill()
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "pretended_replay.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;
using testing::Outcome;

void expect_says(const std::string& text, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        EXPECT_NE(text.find(word), std::string::npos) << word << " in:\n" << text;
}

class RegressRun : public testing::PretendedReplay {
  protected:
    /// Content of every result file by its path, except files that differ from run to run.
    std::map<std::string, std::string> results(const std::string& output) const {
        std::map<std::string, std::string> files;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_ / output))
            if (entry.is_regular_file() && entry.path().filename() != "timing.json")
                files[entry.path().lexically_relative(folder_ / output)] =
                    text_of(entry.path().lexically_relative(folder_));
        return files;
    }

    nlohmann::json failure(const std::string& id) const {
        return nlohmann::json::parse(text_of("out/failed/" + id + "/failure.json"));
    }

    /// Runs in a child process until the hanging rawlog is running, sends it a signal, and returns the state
    /// of waitpid().
    int state_after(int signal) {
        add("endless", "hang");
        mkfifo((folder_ / "started").c_str(), 0600);
        const pid_t child = fork();
        if (child == 0) _exit(run({"--quiet", "--jobs", "1"}).status);
        std::string word;
        std::ifstream(folder_ / "started") >> word;
        EXPECT_EQ(word, "now");
        kill(child, signal);
        int state = 0;
        waitpid(child, &state, 0);
        return state;
    }
};

TEST_F(RegressRun, EveryRawlogIsReplayedAndMergedInTheOrderOfTheManifest) {
    const Outcome outcome = run({"--jobs", "2"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    expect_says(outcome.out, {"3 of 3: 3 replayed", "merged.csv"});
    EXPECT_EQ(text_of("out/merged.csv"),
              "id,outcome,status,drive.duration_s,status.ok\n"
              "one,done,0,2.5,13\ntwo,done,0,2.5,13\nthree,done,0,2.5,15\n");
    const auto merged = nlohmann::json::parse(text_of("out/merged.json"));
    EXPECT_EQ(merged["replayed_by"], "flownav-replay 9.1");
    EXPECT_EQ(merged["done"], 3);
    EXPECT_EQ(text_of("out/done/two/trajectory.tum"), "way of two\n");
}

TEST_F(RegressRun, WhatIsDoneIsNotReplayedAgain) {
    run();
    EXPECT_EQ(run().status, 0);
    EXPECT_EQ(calls().size(), std::string("one two three ").size());
    run({"--force"});
    EXPECT_EQ(calls().size(), 2 * std::string("one two three ").size());
}

TEST_F(RegressRun, OtherSettingsAnotherProgramOrAnotherFileAreReplayedAgain) {
    run({"--jobs", "1"});
    run({"--jobs", "1", "--set", "obstacles.tau_px=1.25"});  // the default
    EXPECT_EQ(calls(), "one\ntwo\nthree\n");
    run({"--jobs", "1", "--set", "obstacles.tau_px=2"});
    EXPECT_EQ(calls(), "one\ntwo\nthree\none\ntwo\nthree\n");
    expect_says(text_of("out/merged.csv"), {"one,done,0,2.5,132\n"});
    expect_says(text_of("out/done/one/config.ini"), {"[obstacles]\ntau_px = 2\n"});
    write_program("9.2");
    run({"--jobs", "1", "--set", "obstacles.tau_px=2"});
    EXPECT_EQ(calls(), "one\ntwo\nthree\none\ntwo\nthree\none\ntwo\nthree\n");
    lines_.clear();
    add("one", "fine fine");
    run({"--jobs", "1", "--set", "obstacles.tau_px=2"});
    EXPECT_EQ(calls().substr(calls().size() - 9), "fine one\n");
}

TEST_F(RegressRun, OneBadRawlogDoesNotStopTheOthers) {
    lines_.clear();
    add("cut", "damaged");
    add("broken", "crash");
    add_line("gone gone.rawlog " + std::string(64, '0'));
    add("changed", "fine");
    std::ofstream(folder_ / "changed.rawlog") << "fine changed!";
    add("one", "fine");
    const Outcome outcome = run();
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(has("out/done/one/result.json"));
    EXPECT_EQ(failure("cut")["status"], 2);
    EXPECT_EQ(failure("cut")["reason"], "ended with status 2");
    EXPECT_EQ(failure("cut")["messages"], "first line\nit is damaged\n");
    EXPECT_EQ(failure("cut")["figures"]["status.ok"], 3);
    EXPECT_EQ(failure("broken")["status"], -1);
    EXPECT_EQ(failure("broken")["reason"], "was ended by signal 11 (Segmentation fault)");
    expect_says(failure("gone")["messages"], {"cannot read", "gone.rawlog", "No such file"});
    expect_says(failure("changed")["messages"], {"changed.rawlog is not the file of the manifest", "sha256"});
    expect_says(outcome.error, {"cut: ended with status 2: it is damaged\n"});
    EXPECT_TRUE(fs::is_empty(folder_ / "out/tmp"));
}

TEST_F(RegressRun, AReplayThatHangsIsEnded) {
    lines_.clear();
    add("endless", "hang");
    add("one", "fine");
    // Without a reader for the FIFO, the pretended replay finds a plain file.
    EXPECT_EQ(run({"--time-limit", "0.2"}).status, 1);
    EXPECT_EQ(failure("endless")["reason"], "took longer than 0.2 s");
    EXPECT_TRUE(has("out/done/one"));
}

TEST_F(RegressRun, WhatFailedIsTriedAgainAndForgottenWhenItIsFine) {
    add("four", "damaged");
    EXPECT_EQ(run().status, 1);
    EXPECT_EQ(run().status, 1);
    lines_ = lines_.substr(0, lines_.find("four"));
    add("four", "fine");
    EXPECT_EQ(run().status, 0);
    EXPECT_FALSE(has("out/failed/four"));
}

TEST_F(RegressRun, WhatCannotBeStoredIsToBeTriedAgain) {
    add("four", "unwritable");
    const Outcome outcome = run();
    EXPECT_EQ(outcome.status, 75);
    expect_says(outcome.error, {"four: no space"});
    EXPECT_FALSE(has("out/failed/four"));
    EXPECT_TRUE(has("out/done/one"));
}

TEST_F(RegressRun, ShardsTogetherGiveWhatOneRunGives) {
    add("cut", "damaged");
    run({}, "whole");
    for (const char* shard : {"1", "0", "2"}) run({"--shard", shard, "--shards", "3"}, "parts");
    EXPECT_FALSE(has("parts/merged.json"));
    EXPECT_EQ(regress("merge", {}, "parts").status, 3);
    EXPECT_EQ(results("parts"), results("whole"));
    EXPECT_GT(results("whole").size(), 10U);
}

TEST_F(RegressRun, ASecondRunGivesTheSameBytesApartFromTiming) {
    run({}, "first");
    run({}, "second");
    EXPECT_EQ(results("first"), results("second"));
    EXPECT_NE(text_of("first/done/one/timing.json"), text_of("second/done/one/timing.json"));
}

TEST_F(RegressRun, FiguresAloneAreKeptWhenAskedFor) {
    run({"--keep", "figures"});
    EXPECT_FALSE(has("out/done/one/trajectory.tum"));
    EXPECT_TRUE(has("out/done/one/result.json"));
    expect_says(text_of("out/merged.csv"), {"one,done,0,2.5,13\n"});
}

TEST_F(RegressRun, MergeTellsWhatIsMissingAndWhatFailed) {
    add("cut", "damaged");
    run({"--shard", "1", "--shards", "2"});
    const Outcome missing = regress("merge", {"--missing"});
    EXPECT_EQ(missing.status, 3);
    EXPECT_EQ(missing.out, "0,2\n");
    EXPECT_EQ(regress("merge", {"--failed"}).out, "3\n");
    const Outcome merge = regress("merge");
    EXPECT_EQ(merge.status, 3);
    expect_says(merge.out, {"4 rawlogs: 1 done, 1 failed, 2 missing"});
    expect_says(merge.error, {"one: missing", "cut: failed, ended with status 2"});
}

TEST_F(RegressRun, ResultsOfTwoSettingsAreNotMerged) {
    run({"--shard", "0", "--shards", "2"});
    run({"--shard", "1", "--shards", "2", "--set", "obstacles.tau_px=2"});
    const Outcome merge = regress("merge");
    EXPECT_EQ(merge.status, 2);
    expect_says(merge.error,
                {"different programs or settings", "1 by flownav-replay 9.1", "2 by flownav-replay 9.1"});
    EXPECT_FALSE(has("out/merged.json"));
}

TEST_F(RegressRun, SigtermEndsItWithNothingHalfStored) {
    const int state = state_after(SIGTERM);
    ASSERT_TRUE(WIFEXITED(state));
    EXPECT_EQ(WEXITSTATUS(state), 143);
    EXPECT_TRUE(has("out/done/three"));
    EXPECT_FALSE(has("out/failed/endless"));
    EXPECT_TRUE(fs::is_empty(folder_ / "out/tmp"));
}

TEST_F(RegressRun, AfterSigkillTheNextRunGoesOnFromThere) {
    EXPECT_TRUE(WIFSIGNALED(state_after(SIGKILL)));
    EXPECT_FALSE(fs::is_empty(folder_ / "out/tmp"));
    EXPECT_EQ(run({"--shard", "0", "--shards", "4"}).status, 0);
    EXPECT_EQ(calls(), "one\ntwo\nthree\nendless\n");
    EXPECT_TRUE(fs::is_empty(folder_ / "out/tmp"));
}

TEST_F(RegressRun, CheckComparesWithWhatWasAccepted) {
    run();
    EXPECT_EQ(regress("check").status, 2);  // without an expectation
    EXPECT_EQ(regress("accept").status, 0);
    EXPECT_EQ(regress("check").status, 0);
    run({"--set", "obstacles.tau_px=2"}, "other");
    const Outcome check = regress("check", {"--junit", folder_ / "junit.xml"}, "other");
    EXPECT_EQ(check.status, 1);
    expect_says(check.out, {"one\n    status.ok: 13 -> 132, up by 119 (+915.4 %), better; allowed 1\n",
                            "3 rawlogs, 3 not as expected"});
    expect_says(text_of("junit.xml"), {"failures=\"3\""});
    const Outcome accept = regress("accept", {}, "other");
    expect_says(accept.out, {"two: status.ok: 13 -> 132", "3 changes"});
    EXPECT_EQ(regress("check", {}, "other").status, 0);
}

TEST_F(RegressRun, AnExpectationOfAnotherVersionIsRefused) {
    run();
    regress("accept");
    write_program("9.2");
    run();
    const Outcome check = regress("check");
    EXPECT_EQ(check.status, 2);
    expect_says(check.error,
                {"expected.json is of flownav-replay 9.1", "the results are of flownav-replay 9.2"});
    EXPECT_EQ(regress("check", {"--any-version"}).status, 0);
}

TEST_F(RegressRun, ASweepReplaysEveryCombination) {
    const Outcome outcome = regress("sweep", {"--set", "obstacles.tau_px=1,2", "--set",
                                              "flow.confidence_min=0.1,0.2,0.3", "--program", program()});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    const std::string csv = text_of("out/sweep.csv");
    expect_says(csv, {"obstacles.tau_px,flow.confidence_min,id,outcome,status,drive.duration_s,status.ok\n",
                      "\n1,0.3,three,done,0,2.5,151\n", "\n2,0.1,one,done,0,2.5,132\n"});
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 3 * 3);
    expect_says(text_of("out/sweep.html"), {"<!DOCTYPE html>", "\"obstacles.tau_px\"", "\"status.ok\""});
    EXPECT_TRUE(has("out/points/obstacles.tau_px=2,flow.confidence_min=0.3/done/one/result.json"));
    regress("sweep", {"--set", "obstacles.tau_px=1,2", "--set", "flow.confidence_min=0.1,0.2,0.3",
                      "--program", program()});
    EXPECT_EQ(calls().size(), 6 * std::string("one two three ").size());
}

TEST_F(RegressRun, BadUsageIsExplained) {
    const auto expect_refused = [](const Outcome& outcome, const std::vector<std::string>& words) {
        EXPECT_EQ(outcome.status, 2);
        expect_says(outcome.error, words);
    };
    const auto app = [](const std::vector<std::string>& words) {
        return testing::run_app(run_regress_app, "flownav-regress", words);
    };
    expect_refused(app({}), {"needs a command", "sweep"});
    expect_refused(app({"fly"}), {"unknown command 'fly'"});
    expect_refused(app({"run"}), {"run needs --manifest"});
    expect_refused(app({"compare", "one"}), {"two folders"});
    expect_refused(app({"run", "--nonsense"}), {"--nonsense"});
    expect_refused(regress("check", {"--jobs", "2"}), {"--jobs is no option of check"});
    expect_refused(regress("merge"), {"no such folder"});
    expect_refused(run({"--jobs", "0"}), {"--jobs 0", "1.."});
    expect_refused(run({"--time-limit", "-1"}), {"--time-limit"});
    expect_refused(run({"--keep", "some"}), {"--keep some", "all or figures"});
    expect_refused(run({"--set", "obstacles.tau=1"}), {"obstacles.tau_px"});
    expect_refused(run({"--shard", "3", "--shards", "3"}), {"0..2"});
    expect_refused(regress("run", {"--program", "/nowhere"}), {"--program /nowhere"});
    expect_refused(regress("sweep", {"--set", "obstacles.tau_px=1,1"}), {"twice"});
    expect_refused(regress("sweep", {"--set", "obstacles.tau_px=1,99"}), {"obstacles.tau_px = 99"});
    expect_refused(regress("sweep"), {"sweep needs --set"});
    add_line("a/b one.rawlog " + std::string(64, '0'));
    expect_refused(run(), {"line 4", "identifier 'a/b'"});
    EXPECT_FALSE(has("out"));
}

}  // namespace
}  // namespace flownav
