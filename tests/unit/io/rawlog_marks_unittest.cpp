#include <gtest/gtest.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose2D.h>

#include <fstream>

#include "flownav/io/field_source.h"
#include "flownav/io/rawlog_reader.h"
#include "rawlog_files.h"

namespace flownav::io {
namespace {

using namespace flownav::testing;
using Mark = std::shared_ptr<const RawlogReader::Mark>;
using Objects = std::vector<mrpt::serialization::CSerializable::ConstPtr>;

std::string bytes_of(const mrpt::obs::CObservation::Ptr& observation) {
    return serialized({observation});
}

std::vector<std::string> read_rest(RawlogReader& reader) {
    std::vector<std::string> rest;
    while (const auto observation = reader.next()) rest.push_back(bytes_of(observation));
    return rest;
}

/// Reads a file from start to end, then resumes at each mark, the last first, with another reader.
void expect_the_same_from_every_mark(const std::filesystem::path& file) {
    RawlogReader straight(file);
    std::vector<Mark> marks = {straight.mark()};
    std::vector<std::string> all;
    while (const auto observation = straight.next()) {
        all.push_back(bytes_of(observation));
        marks.push_back(straight.mark());
    }
    ASSERT_GT(all.size(), 8U);
    RawlogReader jumping(file);
    for (std::size_t i = marks.size(); i-- > 0;) {
        jumping.go_to(*marks[i]);
        const std::vector<std::string> expected(all.begin() + static_cast<std::ptrdiff_t>(i), all.end());
        EXPECT_EQ(read_rest(jumping), expected) << "from observation " << i;
        EXPECT_EQ(jumping.end().kind, straight.end().kind);
        EXPECT_EQ(jumping.end().objects_read, straight.end().objects_read);
        EXPECT_EQ(jumping.end().message, straight.end().message);
    }
}

std::filesystem::path file_of(const std::string& bytes) {
    const auto file = test_folder() / "input.rawlog";
    write_bytes(file, bytes);
    return file;
}

/// Frames of two observations each, with an odometry action before each frame.
Objects frames() {
    Objects objects;
    for (unsigned i = 0; i < 6; ++i) {
        auto actions = mrpt::obs::CActionCollection::Create();
        mrpt::obs::CActionRobotMovement2D movement;
        movement.timestamp = mrpt::Clock::fromDouble(100 + 0.04 * i);
        movement.computeFromOdometry(mrpt::poses::CPose2D(0.1, 0, 0.01), {});
        actions->insert(movement);
        objects.push_back(actions);
        auto frame = mrpt::obs::CSensoryFrame::Create();
        frame->insert(image_at(100 + 0.04 * i, i + 1));
        frame->insert(truth_at(100 + 0.04 * i, 0.1 * i));
        objects.push_back(frame);
    }
    return objects;
}

TEST(RawlogMarks, PlainFileIsReadFromEveryMark) {
    expect_the_same_from_every_mark(file_of(serialized(small_recording())));
}

TEST(RawlogMarks, GzFileIsReadFromEveryMarkWithItsChecksum) {
    expect_the_same_from_every_mark(file_of(gz(serialized(small_recording()))));
}

TEST(RawlogMarks, GzFileOfSeveralMembersIsReadFromEveryMark) {
    const std::string all = serialized(small_recording());
    expect_the_same_from_every_mark(
        file_of(gz(all.substr(0, 5000)) + gz(all.substr(5000, 7000)) + gz(all.substr(12000))));
}

TEST(RawlogMarks, SensoryFramesAndOdometryOfActionsAreReadFromEveryMark) {
    expect_the_same_from_every_mark(file_of(gz(serialized(frames()))));
}

TEST(RawlogMarks, DamageIsFoundAgainFromEveryMark) {
    const std::string all = gz(serialized(small_recording()));
    expect_the_same_from_every_mark(file_of(all.substr(0, all.size() * 3 / 4)));
    std::string wrong_checksum = all;
    wrong_checksum[all.size() - 6] = static_cast<char>(wrong_checksum[all.size() - 6] ^ 1);
    expect_the_same_from_every_mark(file_of(wrong_checksum));
}

TEST(RawlogMarks, ACopiedSourceGoesOnFromAMark) {
    const auto file = file_of(gz(serialized(small_recording())));
    RawlogReader reader(file);
    config::CameraConfig camera;
    camera.interlaced = config::Interlaced::TopFirst;  // the second fields wait for the next frame
    FieldSource source(reader, camera);
    for (int i = 0; i < 7; ++i) source.next();
    const Mark mark = reader.mark();
    FieldSource again(reader, source);
    std::vector<double> expected_s;
    while (const auto event = source.next()) {
        if (const auto* field = std::get_if<Field>(&*event)) expected_s.push_back(field->timestamp_s);
    }
    reader.go_to(*mark);
    std::vector<double> times_s;
    while (const auto event = again.next()) {
        if (const auto* field = std::get_if<Field>(&*event)) times_s.push_back(field->timestamp_s);
    }
    EXPECT_GT(times_s.size(), 8U);
    EXPECT_EQ(times_s, expected_s);
    EXPECT_EQ(again.counts().fields, source.counts().fields);
}

TEST(RawlogMarks, AReaderAtTheEndOfAGrowingFileGoesOn) {
    for (const bool compressed : {false, true}) {
        const std::string plain = serialized(small_recording());
        const std::string all = compressed ? gz(plain) : plain;
        const std::size_t cut = all.size() / 2 + 9;  // a place inside an object
        const auto file = file_of(all.substr(0, cut));
        RawlogReader reader(file);
        std::vector<std::string> read = read_rest(reader);
        EXPECT_EQ(reader.end().kind, ReadEnd::Kind::Truncated);
        EXPECT_LT(read.size(), 20U);
        std::ofstream(file, std::ios::binary | std::ios::app) << all.substr(cut);
        reader.go_to(*reader.mark());
        for (std::string& more : read_rest(reader)) read.push_back(std::move(more));
        EXPECT_EQ(read.size(), 24U);
        EXPECT_EQ(reader.end().kind, ReadEnd::Kind::Clean) << reader.end().message;
        EXPECT_EQ(reader.end().objects_read, 24U);
    }
}

}  // namespace
}  // namespace flownav::io
