#include "recording.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "flownav/io/output_file.h"
#include "grab_samples.h"

namespace flownav {
namespace {

namespace fs = std::filesystem;
using testing::bytes_of;
using testing::noise;
using testing::unpacked;

class RecordingOf : public ::testing::Test {
  protected:
    RecordingOptions options(std::uint64_t max_bytes = 0, bool overwrite = false) const {
        return {file, max_bytes, overwrite, 1};
    }
    const fs::path folder = testing::grab_test_folder();
    const fs::path file = folder / "r.rawlog";
};

TEST_F(RecordingOf, NothingIsAGzFileToo) {
    Recording(options()).close();
    EXPECT_EQ(unpacked(file), "");
    EXPECT_GT(fs::file_size(file), 10U);
}

TEST_F(RecordingOf, AFileIsWholeAfterEveryFlush) {
    Recording recording(options());
    std::string expected;
    for (const char* text : {"one", "two", "three"}) {
        recording.add(bytes_of(text));
        EXPECT_EQ(unpacked(file), expected) << "not before the flush";
        expected += text;
        recording.flush();
        EXPECT_EQ(unpacked(file), expected);
        EXPECT_EQ(recording.written_bytes(), fs::file_size(file));
    }
    recording.close();
    EXPECT_EQ(unpacked(file), expected);
}

TEST_F(RecordingOf, ObjectsOfOneFlushAreOneMember) {
    Recording recording(options());
    const auto empty = recording.written_bytes();
    recording.flush();
    EXPECT_EQ(recording.written_bytes(), empty) << "nothing was pending";
    recording.add(bytes_of("a"));
    recording.add(bytes_of("b"));
    EXPECT_EQ(recording.pending_bytes(), 2U);
    recording.flush();
    EXPECT_EQ(recording.pending_bytes(), 0U);
    EXPECT_EQ(unpacked(file), "ab");
}

TEST_F(RecordingOf, ClosingWritesWhatIsPending) {
    Recording recording(options());
    recording.add(bytes_of("last words"));
    recording.close();
    EXPECT_EQ(unpacked(file), "last words");
}

TEST_F(RecordingOf, TheSameObjectsGiveTheSameBytes) {
    for (const char* name : {"a", "b"}) {
        Recording recording({folder / name, 0, false, 6});
        recording.add(noise(1000, 3));
        recording.close();
    }
    std::ifstream a(folder / "a", std::ios::binary);
    std::ifstream b(folder / "b", std::ios::binary);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(a), {}),
              std::string(std::istreambuf_iterator<char>(b), {}));
}

TEST_F(RecordingOf, AMemberThatWouldPassTheLimitBeginsTheNextFile) {
    Recording recording(options(5000));
    std::string expected;
    for (std::uint32_t i = 0; i < 10; ++i) {
        const auto object = noise(2000, i);
        expected.append(object.begin(), object.end());
        recording.add(object);
        recording.flush();
    }
    recording.close();
    ASSERT_EQ(recording.files().size(), 5U);
    EXPECT_EQ(recording.files()[1], folder / "r_001.rawlog");
    EXPECT_EQ(recording.files()[4], folder / "r_004.rawlog");
    std::string all;
    std::uint64_t bytes = 0;
    for (const fs::path& part : recording.files()) {
        EXPECT_LE(fs::file_size(part), 5000U);
        bytes += fs::file_size(part);
        all += unpacked(part);
    }
    EXPECT_EQ(all, expected);
    EXPECT_EQ(recording.written_bytes(), bytes);
}

TEST_F(RecordingOf, AMemberLargerThanTheLimitGetsAFileOfItsOwn) {
    Recording recording(options(1000));
    for (std::uint32_t i = 0; i < 3; ++i) {
        recording.add(noise(3000, i));
        recording.flush();
    }
    recording.close();
    EXPECT_EQ(recording.files().size(), 3U);
    for (const fs::path& part : recording.files()) EXPECT_EQ(unpacked(part).size(), 3000U);
}

TEST_F(RecordingOf, NumbersGrowBeyondThreeDigits) {
    EXPECT_EQ(continuation("x/f.rawlog", 0), "x/f.rawlog");
    EXPECT_EQ(continuation("x/f.rawlog", 7), "x/f_007.rawlog");
    EXPECT_EQ(continuation("x/f.rawlog", 1234), "x/f_1234.rawlog");
    EXPECT_EQ(continuation("f", 1), "f_001");
}

TEST_F(RecordingOf, AFullDiskLeavesTheWholeMembersBefore) {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit limit{10000, before.rlim_max};
    Recording recording(options());
    std::string expected;
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
        for (std::uint32_t i = 0;; ++i) {
            const auto object = noise(3000, i);
            recording.add(object);
            recording.flush();
            expected.append(object.begin(), object.end());
        }
    } catch (const io::OutputError& error) {
        EXPECT_NE(std::string(error.what()).find(file.string() + ": File too large"), std::string::npos)
            << error.what();
    }
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(expected.size(), 9000U);
    EXPECT_EQ(unpacked(file), expected);
}

TEST_F(RecordingOf, ADeviceWithoutSpaceIsAnErrorThatNamesIt) {
    try {
        const Recording recording({"/dev/full", 0, false, 1});
        FAIL() << "nobody noticed";
    } catch (const io::OutputError& error) {
        EXPECT_STREQ(error.what(), "cannot write /dev/full: No space left on device");
    }
}

TEST_F(RecordingOf, OnlyItsOwnContinuationsAreReplaced) {
    const std::vector<fs::path> own = {file, folder / "r_001.rawlog", folder / "r_1000.rawlog"};
    const std::vector<fs::path> foreign = {folder / "r_a01.rawlog", folder / "r_001.txt",
                                           folder / "r_01.rawlog", folder / "rr_001.rawlog"};
    for (const fs::path& path : foreign) std::ofstream(path) << "x";
    Recording(options()).close();
    fs::remove(file);
    for (const fs::path& path : own) {
        std::ofstream(path) << "x";
        EXPECT_THROW(Recording{options()}, FileExists) << path;
        Recording(options(0, true)).close();
        EXPECT_EQ(fs::exists(path), path == file);
        fs::remove(file);
    }
    for (const fs::path& path : foreign) EXPECT_TRUE(fs::exists(path)) << path;
}

}  // namespace
}  // namespace flownav
