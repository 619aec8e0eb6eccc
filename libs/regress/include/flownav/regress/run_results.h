#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "flownav/regress/manifest.h"
#include "flownav/regress/result.h"

namespace flownav::regress {

enum class Outcome { Done, Failed, Missing };

/// Returns "done", "failed" or "missing".
const char* to_string(Outcome outcome);

/// Result of one rawlog in a run.
struct RawlogResult {
    std::string id;
    Outcome outcome = Outcome::Missing;
    std::filesystem::path folder;  ///< done/ID or failed/ID
    Result result;                 ///< empty when it is missing
};

/// Results of all rawlogs of a manifest, in its order.
using RunResults = std::vector<RawlogResult>;

/// Reads done/ and failed/ below `output`. A result of a rawlog with another sha256 than the manifest's
/// counts as missing.
RunResults collect(const Manifest& manifest, const std::filesystem::path& output);

/// Reads the results of all identifiers below `output`, sorted.
RunResults collect_all(const std::filesystem::path& output);

/// Empty when all results are of one program with one set of common settings; otherwise a sentence with the
/// count of each.
std::string mixture_in(const RunResults& results);

/// Line numbers, from 0, of the rawlogs with this outcome, such as "3,17,20".
std::string lines_with(Outcome outcome, const RunResults& results);

std::size_t count(Outcome outcome, const RunResults& results);

/// Program of the results, with its version; empty when there are none.
std::string program_of(const RunResults& results);

/// Text of merged.json and of merged.csv (one row per rawlog, one column per figure). Depends on the results
/// only, not on the order of their creation.
std::string merged_json(const RunResults& results);
std::string merged_csv(const RunResults& results);

/// Names of all figures in the results.
std::set<std::string> figure_names(const RunResults& results);

/// Lines of a CSV: the names of the columns, and the values of a rawlog.
std::string csv_head(const std::set<std::string>& names);
std::string csv_row(const RawlogResult& rawlog, const std::set<std::string>& names);

}  // namespace flownav::regress
