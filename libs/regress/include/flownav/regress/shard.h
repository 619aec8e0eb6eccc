#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace flownav::regress {

/// A part of the work: line k of `count` shards belongs to shard k mod count.
struct Shard {
    std::size_t index = 0;
    std::size_t count = 1;

    bool has(std::size_t line) const { return line % count == index; }
};

/// The value of an environment variable, or nothing.
using Environment = std::function<std::optional<std::string>(const char* name)>;

/// What --shard and --shards say (empty: not given), else the environment as cluster engines set it: the
/// index is the first of SHARD_INDEX, SLURM_ARRAY_TASK_ID, JOB_COMPLETION_INDEX, AWS_BATCH_JOB_ARRAY_INDEX,
/// the count SHARD_COUNT alone; the engines' own counts tell how many were submitted, not how many there are.
/// Nothing where neither is set. Throws UsageError for one without the other, no number, or an index >=
/// count.
std::optional<Shard> find_shard(const std::string& index, const std::string& count,
                                const Environment& environment);

}  // namespace flownav::regress
