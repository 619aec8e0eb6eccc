/// Replays recordings with wrong meta data: each must give the figures of the good one, or a sentence, or a
/// status. Figures that are wrong without a word are errors.
#include <mrpt/3rdparty/tclap/CmdLine.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "corruptions.h"
#include "flownav/io/rawlog_reader.h"
#include "flownav/replay/replay.h"

namespace flownav::bench {
namespace {

namespace fs = std::filesystem;

/// What a replay says about a drive.
struct Outcome {
    int status = 0;
    std::vector<std::string> reasons;
    std::string message;
    double path_m = 0.0, end_x_m = 0.0, end_y_m = 0.0, heading_deg = 0.0, duration_s = 0.0;

    bool says_something() const { return status != 0 || !reasons.empty(); }
};

Recording load(const fs::path& file) {
    Recording recording;
    io::RawlogReader reader(file);
    while (const auto observation = reader.next()) recording.push_back(observation);
    return recording;
}

void save(const Recording& recording, const fs::path& file) {
    constexpr int fast = 1;
    mrpt::io::CFileGZOutputStream stream;
    stream.open(file.string(), fast);
    auto archive = mrpt::serialization::archiveFrom(stream);
    for (const auto& observation : recording) archive << *observation;
}

Outcome replayed(const fs::path& file, const fs::path& output) {
    fs::remove(output / "summary.json");
    replay::ReplayOptions options;
    options.input = file;
    options.output = output;
    const replay::ReplayResult result = replay::replay(options);
    Outcome outcome;
    outcome.status = cli::exit_code(result.status);
    outcome.message = result.message;
    std::ifstream summary(output / "summary.json");
    if (!summary) return outcome;
    const auto json = nlohmann::json::parse(summary);
    for (const auto& warning : json["warnings"]) outcome.reasons.push_back(warning["reason"]);
    const auto& drive = json["drive"];
    if (drive.is_null()) return outcome;
    outcome.path_m = drive["path_m"];
    outcome.end_x_m = drive["end_x_m"];
    outcome.end_y_m = drive["end_y_m"];
    outcome.heading_deg = drive["end_heading_deg"];
    outcome.duration_s = drive["duration_s"];
    return outcome;
}

/// True when the figures are those of the good drive within 2 %.
bool is_right(const Outcome& outcome, const Outcome& good) {
    constexpr double share = 0.02;
    constexpr double heading_floor_deg = 2.0;
    const double end_m = std::hypot(outcome.end_x_m - good.end_x_m, outcome.end_y_m - good.end_y_m);
    const double turn_deg = std::abs(std::remainder(outcome.heading_deg - good.heading_deg, 360.0));
    return std::abs(outcome.path_m - good.path_m) <= share * good.path_m && end_m <= share * good.path_m &&
           turn_deg <= std::max(heading_floor_deg, share * std::abs(good.heading_deg)) &&
           outcome.duration_s >= 0.0 && std::abs(outcome.duration_s / good.duration_s - 1.0) <= 0.1;
}

struct Tally {
    int right = 0, right_and_told = 0, wrong_and_told = 0, silent = 0;
    std::map<std::string, int> reasons;
};

/// One case: the number decides kind and seed.
struct Case {
    int number = 0;
    std::size_t kind = 0;
    Outcome outcome;
};

class Bench {
  public:
    Bench(const fs::path& drive, fs::path scratch, unsigned seed)
        : recording_(load(drive)),
          scratch_(std::move(scratch)),
          seed_(seed),
          good_(replayed(drive, scratch_ / "good")) {}

    const Outcome& good() const { return good_; }

    void run(int cases, int threads) {
        std::vector<std::vector<Case>> done(static_cast<std::size_t>(threads));
        std::vector<std::thread> workers;
        for (int t = 0; t < threads; ++t)
            workers.emplace_back([&, t] {
                for (int i = t; i < cases; i += threads)
                    done[static_cast<std::size_t>(t)].push_back(one(i, t));
            });
        for (std::thread& worker : workers) worker.join();
        for (const auto& list : done)
            for (const Case& made : list) count(made);
    }

    /// Prints the table; returns the number of silent cases.
    int report(std::ostream& out) const {
        int silent = 0;
        out << "| corruption | right | right, told | wrong, told | wrong, silent | reasons "
               "|\n|---|---|---|---|---|---|\n";
        for (const auto& [name, tally] : tallies_) {
            silent += tally.silent;
            out << "| " << name << " | " << tally.right << " | " << tally.right_and_told << " | "
                << tally.wrong_and_told << " | " << tally.silent << " | ";
            for (const auto& [reason, times] : tally.reasons) out << reason << " (" << times << ") ";
            out << "|\n";
        }
        return silent;
    }

  private:
    Case one(int number, int thread) const {
        Dice dice(seed_ * 1000003ULL + static_cast<unsigned>(number));
        Case made;
        made.number = number;
        made.kind = static_cast<std::size_t>(number) % corruptions().size();
        Recording wrong = copy_of(recording_);
        corruptions()[made.kind].apply(wrong, dice);
        const fs::path folder = scratch_ / std::to_string(thread);
        fs::create_directories(folder);
        save(wrong, folder / "wrong.rawlog");
        made.outcome = replayed(folder / "wrong.rawlog", folder / "out");
        return made;
    }

    void count(const Case& made) {
        Tally& tally = tallies_[corruptions()[made.kind].name];
        const Outcome& outcome = made.outcome;
        const bool right = is_right(outcome, good_);
        const bool told = outcome.says_something();
        ++(right ? told ? tally.right_and_told : tally.right : told ? tally.wrong_and_told : tally.silent);
        for (const std::string& reason : outcome.reasons) ++tally.reasons[reason];
        if (outcome.status == 1) ++tally.reasons["refused"];
        if (right || told) return;
        std::cout << "silent: case " << made.number << ", " << corruptions()[made.kind].name << ": way "
                  << outcome.path_m << " of " << good_.path_m << " m, end " << outcome.end_x_m << ' '
                  << outcome.end_y_m << ", heading " << outcome.heading_deg << " of " << good_.heading_deg
                  << " deg, duration " << outcome.duration_s << " of " << good_.duration_s << " s\n";
    }

    Recording recording_;
    fs::path scratch_;
    unsigned seed_;
    Outcome good_;
    std::map<std::string, Tally> tallies_;
};

int run(int argc, char** argv) {
    TCLAP::CmdLine command(
        "Replays recordings with wrong meta data, made of a good one: each must give the "
        "right figures, or say what is wrong. Exit status 1: more than --most did "
        "neither, or the good one gave a warning.");
    TCLAP::UnlabeledValueArg<std::string> drive("drive", "good recording", true, "", "DRIVE.rawlog", command);
    TCLAP::ValueArg<std::string> scratch("", "scratch", "folder for temporary files", true, "", "DIR",
                                         command);
    TCLAP::ValueArg<int> cases("", "cases", "number of recordings", false, 2000, "N", command);
    TCLAP::ValueArg<unsigned> seed("", "seed", "of all that is drawn by lot", false, 1, "N", command);
    TCLAP::ValueArg<int> most("", "most", "recordings that may be wrong without a word", false, 0, "N",
                              command);
    TCLAP::ValueArg<int> threads("", "threads", "cases at once", false, 2, "N", command);
    command.parse(argc, argv);
    fs::create_directories(scratch.getValue());
    Bench bench(drive.getValue(), scratch.getValue(), seed.getValue());
    for (const std::string& reason : bench.good().reasons) std::cout << "false alarm: " << reason << '\n';
    bench.run(cases.getValue(), threads.getValue());
    const int silent = bench.report(std::cout);
    std::cout << cases.getValue() << " recordings, " << silent << " wrong without a word\n";
    return silent > most.getValue() || bench.good().says_something() ? 1 : 0;
}

}  // namespace
}  // namespace flownav::bench

int main(int argc, char** argv) {
    return flownav::bench::run(argc, argv);
}
