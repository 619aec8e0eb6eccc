#include "flownav/regress/sweep.h"

#include <set>
#include <sstream>

#include "flownav/cli/configuration.h"
#include "flownav/cli/usage_error.h"
#include "flownav/regress/commands.h"
#include "flownav/regress/exit_status.h"

namespace flownav::regress {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_points = 10000;

SweepAxis axis_of(const std::string& setting) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos || equals == 0)
        throw cli::UsageError("--set " + setting + ": needs the form section.key=a,b,c");
    SweepAxis axis{setting.substr(0, equals), {}};
    std::istringstream values(setting.substr(equals + 1) + ',');
    std::set<std::string> seen;
    for (std::string value; std::getline(values, value, ',');) {
        if (value.empty() || value.find('/') != std::string::npos)
            throw cli::UsageError("--set " + setting + ": a value must not be empty and hold no '/'");
        if (!seen.insert(value).second)
            throw cli::UsageError("--set " + setting + ": " + value + " stands there twice");
        axis.values.push_back(value);
    }
    return axis;
}

SweepPoint with(const SweepPoint& point, const std::string& key, const std::string& value) {
    SweepPoint more = point;
    more.values.push_back(value);
    more.settings.push_back(key + '=' + value);
    more.name += (more.name.empty() ? "" : ",") + more.settings.back();
    return more;
}

void check_values(const std::vector<SweepAxis>& axes) {
    for (const SweepAxis& axis : axes)
        for (const std::string& value : axis.values) cli::configuration("", {axis.key + '=' + value});
}

fs::path folder_of(const fs::path& output, const SweepPoint& point) {
    return output / "points" / point.name;
}

std::vector<Job> jobs_of(const std::vector<SweepPoint>& points, const Manifest& manifest,
                         const Options& options) {
    JobSetup setup{options.root, options.config, {}, find_replay_program(options.program), {}};
    std::vector<Job> jobs;
    for (const SweepPoint& point : points) {
        setup.settings = point.settings;
        setup.output = folder_of(options.output, point);
        for (Job& job : make_jobs(manifest, setup)) {
            job.title = point.name + ", " + job.id;
            jobs.push_back(std::move(job));
        }
    }
    return jobs;
}

}  // namespace

std::vector<SweepAxis> sweep_axes(const std::vector<std::string>& settings) {
    std::vector<SweepAxis> axes;
    std::set<std::string> keys;
    for (const std::string& setting : settings) {
        axes.push_back(axis_of(setting));
        if (!keys.insert(axes.back().key).second)
            throw cli::UsageError("--set " + setting + ": " + axes.back().key + " is swept already");
    }
    return axes;
}

std::vector<SweepPoint> sweep_points(const std::vector<SweepAxis>& axes) {
    std::vector<SweepPoint> points = {{}};
    for (const SweepAxis& axis : axes) {
        if (points.size() * axis.values.size() > most_points)
            throw cli::UsageError("the sweep has more than " + std::to_string(most_points) + " combinations");
        std::vector<SweepPoint> more;
        for (const SweepPoint& point : points)
            for (const std::string& value : axis.values) more.push_back(with(point, axis.key, value));
        points = std::move(more);
    }
    return points;
}

std::string sweep_csv(const SweepResults& sweep) {
    std::set<std::string> names;
    for (const RunResults& run : sweep.runs) names.merge(figure_names(run));
    std::string text;
    for (const SweepAxis& axis : sweep.axes) text += axis.key + ',';
    text += csv_head(names);
    for (std::size_t k = 0; k < sweep.points.size(); ++k) {
        std::string values;
        for (const std::string& value : sweep.points[k].values) values += value + ',';
        for (const RawlogResult& rawlog : sweep.runs[k]) text += values + csv_row(rawlog, names);
    }
    return text;
}

int run_sweep(const Options& options, std::ostream& out, std::ostream& error) {
    const Manifest manifest = read_manifest(options.manifest);
    SweepResults sweep{sweep_axes(options.settings), {}, {}};
    check_values(sweep.axes);
    sweep.points = sweep_points(sweep.axes);
    const RunTally tally = replay_all(jobs_of(sweep.points, manifest, options), options, out, error);
    if (options.shard || tally.ended_by_signal != 0) return status_of(tally);
    for (const SweepPoint& point : sweep.points)
        sweep.runs.push_back(collect(manifest, folder_of(options.output, point)));
    write_atomically(options.output / "sweep.csv", sweep_csv(sweep));
    write_atomically(options.output / "sweep.html", sweep_html(sweep));
    if (!options.quiet)
        out << sweep.points.size() << " combinations: " << (options.output / "sweep.html").string() << ", "
            << (options.output / "sweep.csv").string() << '\n';
    return status_of(tally);
}

}  // namespace flownav::regress
