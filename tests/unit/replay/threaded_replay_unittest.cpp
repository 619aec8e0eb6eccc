// Decoding and drawing in separate threads, for the thread sanitizer.
#include <gtest/gtest.h>

#include "../support/temporary_folder.h"
#include "flownav/cli/exit_status.h"
#include "flownav/io/decode_ahead.h"
#include "flownav/replay/replay.h"

namespace flownav::replay {
namespace {

using testing::bytes_of;
using testing::TemporaryFolder;

/// Times of all events, and the position where reading ended.
std::vector<double> times_of(bool ahead) {
    io::RawlogReader reader(FLOWNAV_CORRIDOR);
    io::FieldSource source(reader, {});
    std::optional<io::DecodeAhead> thread;
    if (ahead) thread.emplace(source, reader);
    std::vector<double> times_s;
    while (const auto event = (ahead ? thread->next() : io::decode_next(source, reader)).event) {
        const auto* field = std::get_if<Field>(&*event);
        times_s.push_back(field ? field->timestamp_s : std::get<io::PoseSample>(*event).timestamp_s);
    }
    return times_s;
}

TEST(ThreadedReplay, DecodingAheadHandsOutTheSameEvents) {
    const auto times_s = times_of(true);
    EXPECT_GT(times_s.size(), 60U);
    EXPECT_EQ(times_s, times_of(false));
}

TEST(ThreadedReplay, ADecoderThatIsNotReadToItsEndGoesAtOnce) {
    io::RawlogReader reader(FLOWNAV_CORRIDOR);
    io::FieldSource source(reader, {});
    io::DecodeAhead ahead(source, reader);
    EXPECT_TRUE(ahead.next().event);
}

TEST(ThreadedReplay, TwoThreadsGiveTheFilesOfOne) {
    const TemporaryFolder folder;
    for (const int threads : {1, 2}) {
        ReplayOptions options;
        options.input = FLOWNAV_CORRIDOR;
        options.output = folder / std::to_string(threads);
        options.config.pipeline.threads = threads;
        ASSERT_EQ(replay(options).status, cli::ExitStatus::Fine);
    }
    for (const char* name :
         {"trajectory.tum", "obstacles.csv", "contacts.csv", "result.rawlog", "report.html"})
        EXPECT_EQ(bytes_of(folder / "1" / name), bytes_of(folder / "2" / name)) << name;
}

TEST(Replay, EveryMapFileThatCannotBeWrittenIsNamed) {
    const TemporaryFolder folder;
    for (const std::string name : {"map.gridmap.gz", "map.yaml", "map.pgm"}) {
        ReplayOptions options;
        options.input = FLOWNAV_CORRIDOR;
        options.output = folder / ("without_" + name);
        std::filesystem::create_directories(options.output / name);  // a folder of that name is in the way
        const ReplayResult result = replay(options);
        EXPECT_EQ(result.status, cli::ExitStatus::Output);
        EXPECT_NE(result.message.find((options.output / name).string()), std::string::npos) << result.message;
    }
}

}  // namespace
}  // namespace flownav::replay
