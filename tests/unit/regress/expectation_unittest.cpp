#include "flownav/regress/expectation.h"

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <fstream>

#include "app_runs.h"
#include "flownav/cli/usage_error.h"
#include "flownav/regress/junit.h"

namespace flownav::regress {
namespace {

constexpr auto rms = "errors.ground_truth.omega_rms_degps";
constexpr auto bias = "errors.ground_truth.v_bias_percent";
constexpr auto ok = "status.ok";

RawlogResult done(const std::string& id, const Figures& figures) {
    RawlogResult rawlog{id, Outcome::Done, {}, {}};
    rawlog.result.program = "flownav-replay 1";
    rawlog.result.figures = figures;
    return rawlog;
}

RawlogResult failed(const std::string& id, int status) {
    RawlogResult rawlog = done(id, {});
    rawlog.outcome = Outcome::Failed;
    rawlog.result.status = status;
    rawlog.result.reason = "ended with status " + std::to_string(status);
    return rawlog;
}

const RunResults two = {done("a", {{rms, 0.04}, {bias, -0.1}, {ok, 40.0}}),
                        done("b", {{rms, 0.05}, {bias, {}}})};

TEST(Expectation, WhatWasAcceptedIsAsExpected) {
    EXPECT_TRUE(check(accept({}, two), two).empty());
}

TEST(Expectation, WhatMovesOutOfToleranceIsNamedWithItsDirection) {
    RunResults moved = two;
    moved[0].result.figures[rms] = 0.06;
    moved[0].result.figures[ok] = 39.0;  // within tolerance
    const std::vector<Deviation> deviations = check(accept({}, two), moved);
    ASSERT_EQ(deviations.size(), 1U);
    EXPECT_EQ(deviations[0].id, "a");
    EXPECT_EQ(deviations[0].figure, rms);
    EXPECT_EQ(deviations[0].message, "0.04 -> 0.06, up by 0.02 (+50.0 %), worse; allowed 10 %");
}

TEST(Expectation, BetterIsOutOfToleranceToo) {
    RunResults moved = two;
    moved[0].result.figures[bias] = 0.01;
    const std::vector<Deviation> deviations = check(accept({}, two), moved);
    ASSERT_EQ(deviations.size(), 1U);
    EXPECT_EQ(deviations[0].message, "-0.1 -> 0.01, up by 0.11 (+110.0 %), better; allowed 0.05");
}

TEST(Expectation, FiguresThatComeAndGoAreNamed) {
    RunResults moved = two;
    moved[1].result.figures[bias] = 0.5;
    moved[0].result.figures.erase(ok);
    moved[0].result.figures["errors.new"] = 1.0;
    const std::vector<Deviation> deviations = check(accept({}, two), moved);
    ASSERT_EQ(deviations.size(), 3U);
    EXPECT_EQ(deviations[0].message, "expected 40, is not there");
    EXPECT_EQ(deviations[1].message, "is 1, was not there before");
    EXPECT_EQ(deviations[2].message, "expected null, is 0.5");
}

TEST(Expectation, PartsThatTheExpectationLacksAltogetherAreNamedAndNotChecked) {
    RunResults newer = two;
    newer[0].result.figures["contacts.contacts"] = 2.5;
    newer[1].result.figures["contacts.vignetting"] = std::nullopt;
    const Expectation before = accept({}, two);
    EXPECT_TRUE(check(before, newer).empty());
    EXPECT_EQ(unchecked_parts(before, newer), (std::set<std::string>{"contacts"}));
    const Expectation after = accept(before, newer);
    EXPECT_TRUE(unchecked_parts(after, newer).empty());
    newer[0].result.figures["contacts.contacts"] = 9.0;
    EXPECT_EQ(check(after, newer).size(), 1U) << "once accepted it is checked";
}

TEST(Expectation, ARawlogWithoutResultOrExpectationIsNamed) {
    const RunResults other = {RawlogResult{"a", Outcome::Missing, {}, {}}, done("c", {})};
    const std::vector<Deviation> deviations = check(accept({}, two), other);
    ASSERT_EQ(deviations.size(), 3U);
    EXPECT_EQ(deviations[0].message, "no result: it has not been replayed");
    EXPECT_EQ(deviations[1].id, "c");
    EXPECT_EQ(deviations[2].message, "is expected, but not in the manifest");
}

TEST(Expectation, ADamagedRawlogMayBeExpectedToFail) {
    const RunResults damaged = {failed("a", 2)};
    const Expectation expectation = accept({}, damaged);
    EXPECT_TRUE(check(expectation, damaged).empty());
    EXPECT_EQ(check(expectation, {done("a", {})}).size(), 1U);
    EXPECT_NE(check(expectation, {failed("a", -1)}).at(0).message.find("expected 2"), std::string::npos);
}

TEST(Expectation, AcceptingKeepsTheTolerancesThatPeopleChose) {
    Expectation mine = accept({}, two);
    mine.rawlogs["a"].figures[rms].tolerance = {0.5, true};
    RunResults moved = two;
    moved[0].result.figures[rms] = 0.08;
    const Expectation after = accept(mine, moved);
    EXPECT_EQ(after.rawlogs.at("a").figures.at(rms).value, 0.08);
    EXPECT_EQ(after.rawlogs.at("a").figures.at(rms).tolerance.value, 0.5);
    const std::vector<std::string> lines = difference(mine, after);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0], "a: errors.ground_truth.omega_rms_degps: 0.04 -> 0.08, up by 0.04 (+100.0 %), worse");
}

TEST(Expectation, AcceptingForgetsRawlogsThatAreInTheManifestNoMore) {
    const Expectation after = accept(accept({}, two), {two[0], RawlogResult{"x", Outcome::Missing, {}, {}}});
    EXPECT_EQ(after.rawlogs.size(), 1U);
    EXPECT_EQ(difference(accept({}, two), after).at(0), "b: gone");
}

class ExpectationFile : public ::testing::Test {
  protected:
    std::filesystem::path put(const std::string& text) const {
        const std::filesystem::path file = folder_ / "expected.json";
        std::ofstream(file) << text;
        return file;
    }
    std::string message_of(const std::string& text) const {
        try {
            read_expectation(put(text));
        } catch (const cli::UsageError& error) {
            return error.what();
        }
        return "";
    }
    std::filesystem::path folder_ = testing::folder_of_test("expectation");
};

TEST_F(ExpectationFile, ReadsBackToTheSameText) {
    const Expectation expectation = accept({}, two);
    const std::string text = expectation_text(expectation);
    const Expectation again = read_expectation(put(text));
    EXPECT_EQ(expectation_text(again), text);
    EXPECT_TRUE(difference(expectation, again).empty());
    EXPECT_TRUE(check(again, two).empty());
}

TEST_F(ExpectationFile, WhatCannotBeUnderstoodIsNamed) {
    EXPECT_THROW(read_expectation(folder_ / "none.json"), cli::UsageError);
    EXPECT_NE(message_of("{\"format\": 2}").find("format is 2, this program reads format 1"),
              std::string::npos);
    EXPECT_NE(message_of("{").find("expected.json"), std::string::npos);
    const std::string figure = R"({"format":1,"replayed_by":"x","rawlogs":{"a":{"status":0,"figures":{"f":)";
    EXPECT_NE(message_of(figure + R"({"value":1}}}}})").find("a, f: needs either"), std::string::npos);
    EXPECT_NE(message_of(figure + R"({"value":1,"absolute":-1}}}}})").find("from 0 on"), std::string::npos);
    EXPECT_NE(message_of(figure + R"({"value":"x","absolute":1}}}}})").find("a, f: "), std::string::npos);
}

TEST(Junit, ATestCaseARawlogWithWhatIsOutOfTolerance) {
    RunResults moved = two;
    moved[0].result.figures[rms] = 0.03;
    const std::string xml = junit_xml("a <list>", moved, check(accept({}, two), moved));
    tinyxml2::XMLDocument document;
    ASSERT_EQ(document.Parse(xml.c_str()), tinyxml2::XML_SUCCESS);
    const auto* suite = document.FirstChildElement("testsuite");
    EXPECT_STREQ(suite->Attribute("name"), "a <list>");
    EXPECT_EQ(suite->IntAttribute("tests"), 2);
    EXPECT_EQ(suite->IntAttribute("failures"), 1);
    const auto* first = suite->FirstChildElement("testcase");
    EXPECT_STREQ(first->Attribute("name"), "a");
    EXPECT_NE(std::string(first->FirstChildElement("failure")->GetText()).find(rms), std::string::npos);
    EXPECT_EQ(first->NextSiblingElement("testcase")->FirstChildElement("failure"), nullptr);
}

}  // namespace
}  // namespace flownav::regress
