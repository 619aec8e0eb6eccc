#include "disk_writer.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "flownav/io/output_file.h"
#include "grab_samples.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;
using testing::bytes_of;
using testing::noise;
using testing::unpacked;

constexpr std::uint64_t plenty = 1U << 30;

TEST(DiskWriter, WritesAllInTheOrderOfTime) {
    const fs::path file = testing::grab_test_folder() / "f.rawlog";
    DiskWriter writer({file, 0, false, 1}, plenty);
    writer.put({30, "A", bytes_of("three")});
    writer.put({10, "B", bytes_of("one")});
    writer.put({20, "A", bytes_of("two")});
    writer.finish();
    EXPECT_EQ(unpacked(file), "onetwothree");
    const WriterCounts counts = writer.counts();
    EXPECT_EQ(counts.written, (std::map<std::string, std::uint64_t>{{"A", 2}, {"B", 1}}));
    EXPECT_TRUE(counts.dropped.empty());
    EXPECT_EQ(counts.lost, 0U);
    EXPECT_EQ(counts.file_bytes, fs::file_size(file));
    EXPECT_EQ(writer.failure(), "");
}

/// A disk that blocks until it is opened for reading: a pipe without a reader.
class StuckDisk : public ::testing::Test {
  protected:
    StuckDisk() {
        mkfifo(file.c_str(), 0600);
        reader_ = open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    }
    ~StuckDisk() override { close(reader_); }

    /// Reads the pipe so that the writer can finish.
    void empty_it(DiskWriter& writer) const {
        std::thread drain([this] {
            char buffer[65536];
            while (read(reader_, buffer, sizeof(buffer)) != 0) std::this_thread::yield();
        });
        writer.finish();
        drain.join();
    }

    const fs::path file = testing::grab_test_folder() / "pipe";

  private:
    int reader_ = -1;
};

TEST_F(StuckDisk, CapturingGoesOnAndWhatDoesNotFitIsCounted) {
    DiskWriter writer({file, 0, false, 0}, 1000000);
    const auto object = noise(100000, 1);
    for (int i = 0; i < 100; ++i) writer.put({i, i % 2 == 0 ? "EVEN" : "ODD", object});
    WriterCounts counts = writer.counts();
    EXPECT_LE(counts.queue_bytes, 1000000U);
    EXPECT_GT(counts.dropped.at("EVEN"), 20U);
    EXPECT_GT(counts.dropped.at("ODD"), 20U);
    empty_it(writer);
    counts = writer.counts();
    EXPECT_EQ(counts.dropped["EVEN"] + counts.dropped["ODD"] + counts.written["EVEN"] + counts.written["ODD"],
              100U);
    EXPECT_EQ(counts.lost, 0U);
}

TEST_F(StuckDisk, ASourceThatCanWaitLosesNothing) {
    DiskWriter writer({file, 0, false, 0}, 1000000);
    std::thread source([&] {
        for (int i = 0; i < 40; ++i) writer.put_when_there_is_room({i, "FILE", noise(100000, 1)});
    });
    std::thread drain([&] {
        const int reader = open(file.c_str(), O_RDONLY | O_CLOEXEC);
        char buffer[65536];
        while (read(reader, buffer, sizeof(buffer)) > 0) continue;
        close(reader);
    });
    source.join();
    writer.finish();
    drain.join();
    EXPECT_EQ(writer.counts().written["FILE"], 40U);
    EXPECT_TRUE(writer.counts().dropped.empty());
}

TEST(DiskWriter, ADiskThatFailsIsReportedWithWhatWasLost) {
    const fs::path file = testing::grab_test_folder() / "f.rawlog";
    DiskWriter writer({file, 1000, false, 1}, plenty);
    fs::create_directories(continuation(file, 1));  // occupies the name of the next file
    for (int i = 0; i < 10; ++i) writer.put({i, "A", noise(400, static_cast<std::uint32_t>(i))});
    writer.finish();
    EXPECT_NE(writer.failure().find("f_001.rawlog"), std::string::npos) << writer.failure();
    const WriterCounts counts = writer.counts();
    EXPECT_EQ(counts.written.at("A") + counts.lost, 10U);
    EXPECT_EQ(unpacked(file).size(), 400 * counts.written.at("A"));
    writer.put({11, "A", noise(4, 1)});
    writer.put_when_there_is_room({12, "A", noise(4, 1)});
    EXPECT_EQ(writer.counts().lost, counts.lost + 2);
}

TEST(DiskWriter, AFolderThatIsNotThereIsAnErrorAtOnce) {
    EXPECT_THROW(DiskWriter({testing::grab_test_folder() / "none" / "f", 0, false, 1}, plenty),
                 io::OutputError);
}

}  // namespace
}  // namespace flownav
