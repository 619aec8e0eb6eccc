#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace flownav::regress {

/// Every number of a summary.json by its path, such as "errors.ground_truth.v_bias_percent"; empty where the
/// summary says null.
using Figures = std::map<std::string, std::optional<double>>;

/// Result of one replay: the content of done/ID/result.json or failed/ID/failure.json. Contains no times, so
/// that equal replays give equal bytes.
struct Result {
    std::string id;
    std::string key;  ///< see Job
    std::string rawlog_sha256;
    std::string program;   ///< program with its version
    std::string setup;     ///< hash common to all rawlogs of a run, see Job
    std::string ini;       ///< settings that are not defaults
    int status = 0;        ///< exit status of the replay; -1 when it did not exit
    std::string reason;    ///< reason of the failure; empty on success
    std::string messages;  ///< last lines of its standard error before it failed
    Figures figures;       ///< from its summary.json, if there is one
};

std::string result_text(const Result& result);

/// Shortest text that reads back as the same number, whole numbers without a point; "null" where there is
/// none.
std::string exact_text(const std::optional<double>& value);

/// Reads a result; empty for a missing or invalid file.
std::optional<Result> read_result(const std::filesystem::path& file);

/// Reads the figures of a summary.json, except its parts `input`, `config` and `timing` and the lists of
/// other observations; empty for a missing or damaged file.
std::optional<Figures> read_figures(const std::filesystem::path& summary_file);

/// Moves the object `timing` from DIR/summary.json to DIR/timing.json, which is then the only file that
/// differs from run to run. No effect without a summary. Throws OutputError.
void part_timing(const std::filesystem::path& folder);

}  // namespace flownav::regress
