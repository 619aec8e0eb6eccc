#include "flownav/regress/shard.h"

#include <charconv>

#include "flownav/cli/usage_error.h"

namespace flownav::regress {

namespace {

constexpr const char* index_names[] = {"SHARD_INDEX", "SLURM_ARRAY_TASK_ID", "JOB_COMPLETION_INDEX",
                                       "AWS_BATCH_JOB_ARRAY_INDEX"};

/// A value and the name of its origin.
struct Source {
    std::string name, text;
};

std::optional<Source> index_source(const std::string& option, const Environment& environment) {
    if (!option.empty()) return Source{"--shard", option};
    for (const char* name : index_names)
        if (const auto value = environment(name)) return Source{name, *value};
    return std::nullopt;
}

std::optional<Source> count_source(const std::string& option, const Environment& environment) {
    if (!option.empty()) return Source{"--shards", option};
    if (const auto value = environment("SHARD_COUNT")) return Source{"SHARD_COUNT", *value};
    return std::nullopt;
}

std::size_t number(const Source& source) {
    std::size_t value = 0;
    const char* end = source.text.data() + source.text.size();
    const auto [stopped, error] = std::from_chars(source.text.data(), end, value);
    if (error != std::errc() || stopped != end)
        throw cli::UsageError(source.name + " is '" + source.text + "': must be a whole number from 0 on");
    return value;
}

}  // namespace

std::optional<Shard> find_shard(const std::string& index, const std::string& count,
                                const Environment& environment) {
    const auto index_from = index_source(index, environment);
    const auto count_from = count_source(count, environment);
    if (!index_from && !count_from) return std::nullopt;
    if (!count_from)
        throw cli::UsageError(index_from->name + " is " + index_from->text +
                              ", but the number of shards is not known: give --shards or set SHARD_COUNT");
    if (!index_from)
        throw cli::UsageError(count_from->name + " is " + count_from->text +
                              ", but which shard is not known: give --shard or set SHARD_INDEX");
    const Shard shard{number(*index_from), number(*count_from)};
    if (shard.count == 0) throw cli::UsageError(count_from->name + " is 0: must be at least 1");
    if (shard.index >= shard.count)
        throw cli::UsageError(index_from->name + " is " + index_from->text + ", but there are only " +
                              count_from->text + " shards (" + count_from->name + "): must be 0.." +
                              std::to_string(shard.count - 1));
    return shard;
}

}  // namespace flownav::regress
