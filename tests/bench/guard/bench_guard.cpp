#include <mrpt/3rdparty/tclap/CmdLine.h>

#include <algorithm>
#include <iostream>

#include "row_file.h"

namespace flownav {
namespace {

struct Arguments {
    TCLAP::CmdLine line{
        "The guard against faults: seeded runs in a simulated lane. Prints a table of what happened; "
        "runs that ROWS already holds are not done again."};
    TCLAP::ValueArg<std::string> rows{"", "rows", "one line a run", true, "", "FILE.csv", line};
    TCLAP::ValueArg<int> runs{"", "runs", "seeds of each fault", false, 200, "N", line};
    TCLAP::ValueArg<int> first{"", "first", "seed", false, 1, "N", line};
    TCLAP::MultiArg<std::string> fault{"", "fault", "only these", false, "NAME", line};
    TCLAP::ValueArg<std::string> sensor{"", "sensor", "flow or lidar", false, "flow", "NAME", line};
    TCLAP::ValueArg<std::string> navigator{"",     "navigator", "lanes or reactive", false, "lanes",
                                           "NAME", line};
    TCLAP::ValueArg<double> near{"",  "mover-near-m", "distance of the mover, at least", false, 0.8, "M",
                                 line};
    TCLAP::ValueArg<double> spread{"",  "mover-spread-m", "and so much more at the most", false, 0.8, "M",
                                   line};
    TCLAP::SwitchArg explain{"", "explain", "what the guard did, to the console", line};
    TCLAP::SwitchArg table_only{"", "table-only", "no more runs", line};
};

std::vector<Fault> faults_of(const std::vector<std::string>& names) {
    std::vector<Fault> faults;
    for (const Fault fault : all_faults) {
        if (names.empty() || std::find(names.begin(), names.end(), to_string(fault)) != names.end())
            faults.push_back(fault);
    }
    return faults;
}

void run_seed(const ScenarioOptions& options, std::uint64_t seed, const std::vector<Fault>& faults,
              const std::string& path, std::vector<RunRow>& rows) {
    const auto done = [&](Fault fault) {
        return std::any_of(rows.begin(), rows.end(),
                           [&](const RunRow& row) { return row.fault == fault && row.seed == seed; });
    };
    if (std::all_of(faults.begin(), faults.end(), done)) return;
    Scenario scenario(options, seed);
    if (!scenario.is_sound()) {
        std::cerr << "seed " << seed << ": without a fault " << to_string(scenario.nominal().outcome)
                  << " after " << scenario.nominal().time_s << " s: " << scenario.nominal().why << "\n";
    }
    for (const Fault fault : faults) {
        if (done(fault)) continue;
        rows.push_back(scenario.run(fault));
        append_row(path, rows.back());
    }
}

int run(int argc, char** argv) {
    Arguments a;
    if (!a.line.parse(argc, argv)) return 0;
    ScenarioOptions options;
    options.sensor = a.sensor.getValue() == "lidar" ? drive::SensorKind::Lidar : drive::SensorKind::Flow;
    options.navigator = a.navigator.getValue();
    options.explain = a.explain.getValue();
    options.mover_near_m = a.near.getValue();
    options.mover_spread_m = a.spread.getValue();
    std::vector<RunRow> rows = read_rows(a.rows.getValue());
    for (int i = 0; i < a.runs.getValue() && !a.table_only.getValue(); ++i) {
        run_seed(options, static_cast<std::uint64_t>(a.first.getValue() + i), faults_of(a.fault.getValue()),
                 a.rows.getValue(), rows);
    }
    std::cout << table_of(rows);
    return 0;
}

}  // namespace
}  // namespace flownav

int main(int argc, char** argv) {
    try {
        return flownav::run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "bench_guard: " << error.what() << "\n";
        return 1;
    }
}
