#include "flownav/cli/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace flownav::cli {
namespace {

TEST(StatusLine, OnATerminalOneLineIsRewritten) {
    std::ostringstream out;
    StatusLine line(out, true);
    line.show("one");
    line.show("two");
    line.clear();
    line.clear();
    EXPECT_EQ(out.str(), "\rone\x1b[K\rtwo\x1b[K\r\x1b[K");
    line.show("last");
    line.end();
    line.end();
    EXPECT_EQ(out.str().substr(out.str().rfind('\r')), "\rlast\x1b[K\n");
}

TEST(StatusLine, ElsewhereEveryTextIsALine) {
    std::ostringstream out;
    StatusLine line(out, false);
    line.show("one");
    line.clear();
    line.show("two");
    line.end();
    EXPECT_EQ(out.str(), "one\ntwo\n");
}

TEST(StatusLine, AStringIsNoTerminal) {
    std::ostringstream out;
    EXPECT_FALSE(is_terminal(out));
    EXPECT_EQ(Progress::style_for(out), Progress::Style::Lines);
}

TEST(Progress, LinesComeEveryTenPercent) {
    std::ostringstream out;
    Progress progress(out, Progress::Style::Lines);
    for (int i = 1; i <= 100; ++i) progress.update(i / 100.0, static_cast<std::uint64_t>(i));
    progress.finish(100);
    const std::string text = out.str();
    EXPECT_EQ(text.substr(0, 31), "10 %, 10 fields\n20 %, 20 fields");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
}

TEST(Progress, TheBarEndsItsLine) {
    std::ostringstream out;
    Progress progress(out, Progress::Style::Bar);
    progress.update(0.5, 1);
    progress.finish(1);
    const std::string bar = "\r[" + std::string(20, '#') + std::string(20, '.') + "] 50 %, 1 field\x1b[K";
    EXPECT_EQ(out.str(), bar + bar + '\n');
}

TEST(Progress, SilenceIsSilent) {
    std::ostringstream out;
    Progress progress(out, Progress::Style::Silent);
    progress.update(1.0, 5);
    progress.finish(5);
    EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace flownav::cli
