#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace flownav::regress {

/// A part of the manifest: line k belongs to shard k mod `count`.
struct Shard {
    std::size_t index = 0;
    std::size_t count = 1;

    bool has(std::size_t line) const { return line % count == index; }
};

/// Returns the value of an environment variable; empty when it is not set.
using Environment = std::function<std::optional<std::string>(const char* name)>;

/// Shard by --shard and --shards (empty: not given), else by the environment of cluster engines. The index is
/// the first of SHARD_INDEX, SLURM_ARRAY_TASK_ID, JOB_COMPLETION_INDEX, AWS_BATCH_JOB_ARRAY_INDEX; the count
/// is SHARD_COUNT alone, because the engines' counts are of submitted tasks. Empty when neither is set.
/// Throws UsageError for one without the other, no number, or an index >= count.
std::optional<Shard> find_shard(const std::string& index, const std::string& count,
                                const Environment& environment);

}  // namespace flownav::regress
