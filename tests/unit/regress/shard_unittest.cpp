#include "flownav/regress/shard.h"

#include <gtest/gtest.h>

#include <map>

#include "flownav/cli/usage_error.h"

namespace flownav::regress {
namespace {

using Variables = std::map<std::string, std::string>;

std::optional<Shard> shard_of(const Variables& variables, const std::string& index = "",
                              const std::string& count = "") {
    return find_shard(index, count, [&](const char* name) -> std::optional<std::string> {
        const auto found = variables.find(name);
        return found == variables.end() ? std::nullopt : std::optional(found->second);
    });
}

void expect_refused(const Variables& variables, const std::string& word, const std::string& index = "",
                    const std::string& count = "") {
    try {
        shard_of(variables, index, count);
        ADD_FAILURE() << "accepted, without a word of " << word;
    } catch (const cli::UsageError& error) {
        EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
}

TEST(Shard, WithoutOneEverythingIsReplayed) {
    EXPECT_FALSE(shard_of({}).has_value());
    EXPECT_FALSE(shard_of({{"SLURM_ARRAY_TASK_COUNT", "5"}}).has_value());
}

TEST(Shard, LineKBelongsToShardKModuloTheCount) {
    const Shard shard = shard_of({}, "1", "3").value();
    EXPECT_FALSE(shard.has(0));
    EXPECT_TRUE(shard.has(1));
    EXPECT_FALSE(shard.has(2));
    EXPECT_TRUE(shard.has(4));
}

TEST(Shard, EveryEngineSaysWhichOneItIs) {
    for (const char* name :
         {"SHARD_INDEX", "SLURM_ARRAY_TASK_ID", "JOB_COMPLETION_INDEX", "AWS_BATCH_JOB_ARRAY_INDEX"}) {
        const Shard shard = shard_of({{name, "2"}, {"SHARD_COUNT", "7"}}).value();
        EXPECT_EQ(shard.index, 2U) << name;
        EXPECT_EQ(shard.count, 7U) << name;
    }
}

TEST(Shard, OptionsComeBeforeTheEnvironmentAndOursBeforeTheEngines) {
    const Variables variables = {{"SHARD_INDEX", "1"}, {"SLURM_ARRAY_TASK_ID", "2"}, {"SHARD_COUNT", "9"}};
    EXPECT_EQ(shard_of(variables).value().index, 1U);
    EXPECT_EQ(shard_of(variables, "3").value().index, 3U);
    EXPECT_EQ(shard_of(variables, "3", "4").value().count, 4U);
}

TEST(Shard, TheNumberOfTasksSubmittedIsNotTheNumberOfShards) {
    expect_refused({{"SLURM_ARRAY_TASK_ID", "2"}, {"SLURM_ARRAY_TASK_COUNT", "7"}}, "SHARD_COUNT");
}

TEST(Shard, WhatMakesNoSenseIsRefusedByName) {
    expect_refused({{"SHARD_INDEX", "7"}, {"SHARD_COUNT", "7"}}, "0..6");
    expect_refused({{"SHARD_COUNT", "7"}}, "SHARD_INDEX");
    expect_refused({}, "--shards", "2");
    expect_refused({}, "--shard", "", "2");
    expect_refused({}, "--shards is 0", "0", "0");
    expect_refused({}, "--shard is '-1'", "-1", "2");
    expect_refused({{"SHARD_COUNT", "2x"}}, "SHARD_COUNT is '2x'", "0");
    expect_refused({{"SHARD_COUNT", ""}}, "SHARD_COUNT is ''", "0");
}

}  // namespace
}  // namespace flownav::regress
