#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace flownav::regress {

/// Every number of a summary.json by its path, such as "errors.ground_truth.v_bias_percent"; empty where the
/// summary says null.
using Figures = std::map<std::string, std::optional<double>>;

/// What came of one replay: the content of done/ID/result.json or failed/ID/failure.json. Without a clock in
/// it, so that the same replay gives the same bytes.
struct Result {
    std::string id;
    std::string key;  ///< see Job
    std::string rawlog_sha256;
    std::string program;   ///< with its version
    std::string setup;     ///< the same for all rawlogs of a run, see Job
    std::string ini;       ///< the settings that are not the defaults
    int status = 0;        ///< exit status of the replay; -1 when it did not exit
    std::string reason;    ///< why it failed, for people; empty when it did not
    std::string messages;  ///< the last lines that it said before it failed
    Figures figures;       ///< of its summary.json, where there is one
};

std::string result_text(const Result& result);

/// Shortest text that reads back as the same number, whole numbers without a point; "null" where there is
/// none.
std::string exact_text(const std::optional<double>& value);

/// Nothing where there is no such file or it is no result.
std::optional<Result> read_result(const std::filesystem::path& file);

/// The figures of a summary.json, without its parts `input`, `config` and `timing` and the lists of what else
/// was in the recording; nothing where there is no such file or it is damaged.
std::optional<Figures> read_figures(const std::filesystem::path& summary_file);

/// Takes the object `timing` out of DIR/summary.json into DIR/timing.json: after this, timing.json is the
/// only file that differs from run to run. Does nothing where there is no summary. Throws OutputError.
void part_timing(const std::filesystem::path& folder);

}  // namespace flownav::regress
