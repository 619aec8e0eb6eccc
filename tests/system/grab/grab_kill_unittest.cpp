#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <random>
#include <thread>

#include "child.h"
#include "grab_files.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;
using testing::Child;
using testing::Sighting;

/// One recording that is ended at a random moment.
struct Victim {
    fs::path journal, rawlog;
    std::unique_ptr<Child> child;
    std::size_t moment = 0;        ///< number of observations after which it is ended
    std::int64_t ended_100ns = 0;  ///< time of its end
};

/// Number of recordings; the environment variable FLOWNAV_GRAB_KILLS overrides it.
int kills() {
    const char* number = std::getenv("FLOWNAV_GRAB_KILLS");
    return number == nullptr ? 4 : std::atoi(number);
}

std::size_t lines_of(const fs::path& file) {
    return testing::journal_of(file).size();
}

std::vector<Victim> started(const fs::path& folder, unsigned seed, int first, int count) {
    std::vector<Victim> victims(static_cast<std::size_t>(count));
    std::mt19937 random(seed + static_cast<unsigned>(first));
    for (int i = 0; i < count; ++i) {
        Victim& victim = victims[static_cast<std::size_t>(i)];
        const std::string name = std::to_string(first + i);
        victim.journal = folder / (name + ".journal");
        victim.rawlog = folder / (name + ".rawlog");
        victim.moment = 1 + random() % 250;  // at most about 1.7 s
        testing::write_text(folder / (name + ".ini"), testing::two_sensors(victim.journal));
        const std::vector<std::string> arguments = {folder / (name + ".ini"), "--output", victim.rawlog,
                                                    "--plugin", FLOWNAV_TEST_SENSOR};
        victim.child = std::make_unique<Child>(FLOWNAV_GRAB, arguments, folder / (name + ".log"));
    }
    return victims;
}

/// Ends each recording when it has reached its moment.
void end_all(std::vector<Victim>& victims, int signal) {
    for (std::size_t ended = 0; ended < victims.size();) {
        for (Victim& victim : victims) {
            if (victim.ended_100ns != 0) continue;
            const bool gone = !victim.child->running();
            if (!gone && lines_of(victim.journal) < victim.moment) continue;
            EXPECT_FALSE(gone) << victim.child->log();
            victim.ended_100ns = mrpt::Clock::now().time_since_epoch().count();
            victim.child->signal(signal);
            ++ended;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

template <typename Check>
void end_at_random_moments(int signal, const Check& check) {
    constexpr int at_once = 4;
    const fs::path folder = testing::grab_folder();
    for (int first = 0; first < kills(); first += at_once) {
        auto victims =
            started(folder, 7U * static_cast<unsigned>(signal), first, std::min(at_once, kills() - first));
        end_all(victims, signal);
        for (Victim& victim : victims) check(victim);
    }
}

void expect_everything(Victim& victim) {
    EXPECT_EQ(victim.child->wait(), 0) << victim.child->log();
    const auto contents = testing::contents_of(victim.rawlog);
    EXPECT_EQ(contents.end.kind, io::ReadEnd::Kind::Clean) << contents.end.message;
    EXPECT_TRUE(testing::missing(testing::journal_of(victim.journal), contents.sightings).empty());
    EXPECT_GE(contents.sightings.size(), victim.moment);
}

TEST(KilledGrab, SigintLosesNothing) {
    end_at_random_moments(SIGINT, expect_everything);
}

TEST(KilledGrab, SigtermLosesNothing) {
    end_at_random_moments(SIGTERM, expect_everything);
}

TEST(KilledGrab, SigkillLosesTheLastHalfSecondAtMost) {
    double worst_s = 0.0;
    int cut_members = 0;
    end_at_random_moments(SIGKILL, [&](Victim& victim) {
        EXPECT_EQ(victim.child->wait(), -SIGKILL);
        const auto contents = testing::contents_of(victim.rawlog);
        const auto journal = testing::journal_of(victim.journal);
        const auto lost = testing::missing(journal, contents.sightings);
        const bool empty_yet = contents.sightings.empty() && lost.size() == journal.size();
        // A kill may interrupt the kernel's last write.
        const bool cut = contents.end.kind == io::ReadEnd::Kind::Truncated;
        cut_members += cut ? 1 : 0;
        EXPECT_TRUE(cut || empty_yet || contents.end.kind == io::ReadEnd::Kind::Clean)
            << contents.end.message;
        for (const Sighting& sighting : lost)
            worst_s = std::max(worst_s, 1e-7 * static_cast<double>(victim.ended_100ns - sighting.second));
    });
    EXPECT_LE(worst_s, 0.5);
    RecordProperty("worst_loss_ms", static_cast<int>(1000 * worst_s));
    std::cout << "oldest lost observation: " << worst_s << " s before the kill; cut members: " << cut_members
              << '\n';
}

}  // namespace
}  // namespace flownav
