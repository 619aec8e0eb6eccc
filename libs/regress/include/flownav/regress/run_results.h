#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "flownav/regress/manifest.h"
#include "flownav/regress/result.h"

namespace flownav::regress {

enum class Outcome { Done, Failed, Missing };

/// "done", "failed", "missing".
const char* to_string(Outcome outcome);

/// What a run has of one rawlog.
struct RawlogResult {
    std::string id;
    Outcome outcome = Outcome::Missing;
    std::filesystem::path folder;  ///< done/ID or failed/ID
    Result result;                 ///< empty when it is missing
};

/// What a run has of every rawlog of a manifest, in its order.
using RunResults = std::vector<RawlogResult>;

/// Reads done/ and failed/ below `output`. A result of a rawlog with another sha256 than the manifest's
/// counts as missing.
RunResults collect(const Manifest& manifest, const std::filesystem::path& output);

/// The same of every identifier that is there, sorted.
RunResults collect_all(const std::filesystem::path& output);

/// Empty when one program with one set of common settings made them all, else a sentence that says how many
/// each made.
std::string mixture_in(const RunResults& results);

/// The line numbers, from 0, of those with this outcome: "3,17,20".
std::string lines_with(Outcome outcome, const RunResults& results);

std::size_t count(Outcome outcome, const RunResults& results);

/// The program that made them, with its version; empty when there are none.
std::string program_of(const RunResults& results);

/// The text of merged.json and of merged.csv (a row a rawlog, a column a figure). Pure functions of the
/// results: the same whoever made them, in whatever order.
std::string merged_json(const RunResults& results);
std::string merged_csv(const RunResults& results);

/// The names of all figures that these results have.
std::set<std::string> figure_names(const RunResults& results);

/// A line of a CSV each: the names of the columns, and a rawlog's values.
std::string csv_head(const std::set<std::string>& names);
std::string csv_row(const RawlogResult& rawlog, const std::set<std::string>& names);

}  // namespace flownav::regress
