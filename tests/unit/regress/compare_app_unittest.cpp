#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "pretended_replay.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;
using testing::Outcome;

class RegressCompare : public testing::PretendedReplay {
  protected:
    Outcome compare(const std::string& before, const std::string& after,
                    std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"compare", folder_ / before, folder_ / after});
        return testing::run_app(run_regress_app, "flownav-regress", more);
    }

    /// The data of the page's script.
    nlohmann::json data_of(const std::string& page) const {
        const std::string text = text_of(page);
        const std::string start = "<script type='application/json' id='data'>";
        const std::size_t from = text.find(start) + start.size();
        return nlohmann::json::parse(text.substr(from, text.find("</script>", from) - from));
    }
};

void expect_says(const std::string& text, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        EXPECT_NE(text.find(word), std::string::npos) << word << " in:\n" << text;
}

TEST_F(RegressCompare, TwoRunsAreComparedAndAPageIsWritten) {
    run({}, "a");
    run({"--set", "obstacles.tau_px=2"}, "b");
    const Outcome outcome = compare("a", "b");
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    expect_says(outcome.out, {"three   status.ok  15  152  +137 (+913.3 %)       137.0  better\n",
                              "obstacles.tau_px: 1.25 (default) -> 2\n", "3 rawlogs in both runs, 3 changed",
                              "b/compare.html"});
    const nlohmann::json data = data_of("b/compare.html");
    EXPECT_EQ(data["ids"].size(), 3U);
    EXPECT_EQ(data["changes"][0]["figure"], "status.ok");
    EXPECT_FALSE(fs::exists(folder_ / "a/compare.html"));
}

TEST_F(RegressCompare, ARunEqualsItself) {
    run({}, "a");
    const Outcome outcome = compare("a", "a", {"--output", folder_ / "same.html"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.out, "3 rawlogs in both runs: every figure is the same.\nPage: " +
                               (folder_ / "same.html").string() + "\n");
    EXPECT_TRUE(data_of("same.html")["changes"].empty());
}

TEST_F(RegressCompare, WhatOneRunLacksIsSaidAndTheRestCompared) {
    run({}, "a");
    run({"--set", "obstacles.tau_px=2", "--shard", "0", "--shards", "2"}, "b");
    const Outcome outcome = compare("a", "b");
    EXPECT_EQ(outcome.status, 1);
    expect_says(outcome.out, {"only in A: two\n", "2 rawlogs in both runs, 2 changed"});
    EXPECT_EQ(data_of("b/compare.html")["ids"].size(), 2U);
}

TEST_F(RegressCompare, ManyChangesAreCutAndQuietIsQuiet) {
    lines_.clear();
    for (int k = 0; k < 45; ++k) add("r" + std::to_string(k), "fine");
    run({}, "a");
    run({"--set", "obstacles.tau_px=2"}, "b");
    const Outcome outcome = compare("a", "b", {"--quiet"});
    expect_says(outcome.out, {"... 5 more, see "});
    EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1 + 40 + 1);
    EXPECT_EQ(data_of("b/compare.html")["changes"].size(), 45U);
    EXPECT_EQ(data_of("b/compare.html")["drives"].size(), 30U);
}

TEST_F(RegressCompare, AFolderWithoutResultsIsRefused) {
    run({}, "a");
    fs::create_directories(folder_ / "empty/done");
    for (const char* other : {"empty", "nowhere"}) {
        const Outcome outcome = compare("a", other);
        EXPECT_EQ(outcome.status, 2);
        expect_says(outcome.error, {other, "no results of flownav-regress run there"});
        EXPECT_EQ(compare(other, "a").status, 2);
    }
    EXPECT_FALSE(fs::exists(folder_ / "a/compare.html"));
}

TEST_F(RegressCompare, APageThatCannotBeWrittenIsSaid) {
    run({}, "a");
    const Outcome outcome = compare("a", "a", {"--output", folder_ / "nowhere/page.html"});
    EXPECT_EQ(outcome.status, 75);
    expect_says(outcome.error, {"nowhere"});
}

}  // namespace
}  // namespace flownav
