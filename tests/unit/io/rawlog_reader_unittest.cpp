#include "flownav/io/rawlog_reader.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose2D.h>

#include "rawlog_files.h"

namespace flownav::io {
namespace {

using namespace flownav::testing;
using Kind = ReadEnd::Kind;

struct ReadResult {
    std::vector<mrpt::obs::CObservation::Ptr> observations;
    ReadEnd end;
};

ReadResult read_all(const std::filesystem::path& file) {
    RawlogReader reader(file);
    ReadResult result;
    while (const auto observation = reader.next()) result.observations.push_back(observation);
    result.end = reader.end();
    return result;
}

ReadResult read_bytes(const std::string& bytes) {
    const auto file = test_folder() / "input.rawlog";
    write_bytes(file, bytes);
    return read_all(file);
}

std::string input_error(const std::filesystem::path& file) {
    try {
        RawlogReader reader(file);
    } catch (const InputError& e) {
        return e.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Offset of the length byte of the class name of object number `index` in the serialized bytes.
std::size_t offset_of(const std::vector<mrpt::serialization::CSerializable::ConstPtr>& objects,
                      std::size_t index) {
    return serialized({objects.begin(), objects.begin() + static_cast<std::ptrdiff_t>(index)}).size();
}

TEST(RawlogReader, MissingFileIsAnError) {
    const std::string message = input_error(test_folder() / "nothing.rawlog");
    EXPECT_TRUE(contains(message, "nothing.rawlog")) << message;
    EXPECT_TRUE(contains(message, "no such file")) << message;
}

TEST(RawlogReader, FolderIsAnError) {
    EXPECT_TRUE(contains(input_error(test_folder()), "is a folder"));
}

TEST(RawlogReader, EmptyFileIsAnError) {
    const auto file = test_folder() / "empty.rawlog";
    write_bytes(file, "");
    EXPECT_TRUE(contains(input_error(file), "is empty"));
    write_bytes(file, gz(""));
    EXPECT_TRUE(contains(input_error(file), "holds no object"));
}

TEST(RawlogReader, TextIsNotARawlog) {
    const auto file = test_folder() / "text.rawlog";
    write_bytes(file, "once upon a time there was a text that was no rawlog");
    EXPECT_TRUE(contains(input_error(file), "is not a rawlog"));
    write_bytes(file, gz("and it was compressed"));
    EXPECT_TRUE(contains(input_error(file), "is not a rawlog"));
}

TEST(RawlogReader, PictureIsNotARawlog) {
    const auto file = test_folder() / "picture.rawlog";
    write_bytes(file, std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16));
    EXPECT_TRUE(contains(input_error(file), "is not a rawlog"));
}

TEST(RawlogReader, OtherMrptFileIsNotARawlog) {
    const auto file = test_folder() / "pose.bin";
    write_bytes(file, serialized({std::make_shared<mrpt::poses::CPose2D>(1, 2, 3)}));
    EXPECT_TRUE(contains(input_error(file), "CPose2D"));
}

TEST(RawlogReader, PlainAndGzListsReadCleanly) {
    const auto objects = small_recording();
    for (const bool compressed : {false, true}) {
        const auto result = read_bytes(compressed ? gz(serialized(objects)) : serialized(objects));
        EXPECT_EQ(result.end.kind, Kind::Clean) << result.end.message;
        EXPECT_EQ(result.end.objects_read, objects.size());
        EXPECT_EQ(result.end.byte_offset, serialized(objects).size());
        EXPECT_EQ(result.observations.size(), objects.size());
        EXPECT_TRUE(result.end.message.empty());
    }
}

TEST(RawlogReader, ConcatenatedGzMembersAreOneRecording) {
    const auto objects = small_recording();
    const auto result = read_bytes(gz(serialized({objects[0], objects[1]})) + gz(serialized({objects[2]})));
    EXPECT_EQ(result.end.kind, Kind::Clean) << result.end.message;
    EXPECT_EQ(result.observations.size(), 3U);
}

TEST(RawlogReader, BytesAfterTheGzStreamAreReported) {
    const auto result = read_bytes(gz(serialized(small_recording())) + "rubbish");
    EXPECT_EQ(result.end.kind, Kind::Corrupt);
    EXPECT_EQ(result.observations.size(), small_recording().size());
}

TEST(RawlogReader, SensoryFramesActionsAndCommentsMix) {
    auto frame = std::make_shared<mrpt::obs::CSensoryFrame>();
    frame->insert(image_at(5.0));
    frame->insert(truth_at(5.0, 1));
    mrpt::obs::CActionRobotMovement2D movement;
    mrpt::obs::CActionRobotMovement2D::TMotionModelOptions model;
    movement.computeFromOdometry(mrpt::poses::CPose2D(0.5, 0, M_PI / 2), model);
    auto actions = std::make_shared<mrpt::obs::CActionCollection>();
    actions->insert(movement);
    auto comment = std::make_shared<mrpt::obs::CObservationComment>();
    comment->text = "a drive";
    const auto result =
        read_bytes(serialized({comment, frame, actions, frame, actions, frame, odometry_at(6, 1)}));
    EXPECT_EQ(result.end.kind, Kind::Clean) << result.end.message;
    ASSERT_EQ(result.observations.size(), 10U);
    const auto* first = dynamic_cast<mrpt::obs::CObservationOdometry*>(result.observations[3].get());
    const auto* second = dynamic_cast<mrpt::obs::CObservationOdometry*>(result.observations[6].get());
    ASSERT_TRUE(first != nullptr && second != nullptr);
    EXPECT_NEAR(first->odometry.x(), 0.5, 1e-9);
    EXPECT_NEAR(second->odometry.x(), 0.5, 1e-9);
    EXPECT_NEAR(second->odometry.y(), 0.5, 1e-9);
    EXPECT_NEAR(mrpt::Clock::toDouble(first->timestamp), 5.0, 1e-6);
}

TEST(RawlogReader, PlainFileCutInsideAnObjectIsTruncated) {
    const auto objects = small_recording();
    const std::string bytes = serialized(objects);
    const std::size_t start = offset_of(objects, 6);
    for (const std::size_t extra : {1U, 10U, 40U, 300U, 2000U}) {
        const auto result = read_bytes(bytes.substr(0, start + extra));
        EXPECT_EQ(result.end.kind, Kind::Truncated) << result.end.message;
        EXPECT_EQ(result.end.objects_read, 6U);
        EXPECT_EQ(result.end.byte_offset, start);
        EXPECT_TRUE(contains(result.end.message, std::to_string(start))) << result.end.message;
        EXPECT_TRUE(contains(result.end.message, "object number 7")) << result.end.message;
    }
}

TEST(RawlogReader, PlainFileCutBetweenObjectsLooksClean) {
    const auto objects = small_recording();
    const auto result = read_bytes(serialized(objects).substr(0, offset_of(objects, 6)));
    EXPECT_EQ(result.end.kind, Kind::Clean);
    EXPECT_EQ(result.end.objects_read, 6U);
}

TEST(RawlogReader, GzFileCutAnywhereIsTruncated) {
    const auto objects = small_recording();
    const std::string bytes = gz(serialized(objects));
    for (const double share : {0.01, 0.3, 0.5, 0.9}) {
        const auto size = static_cast<std::size_t>(share * static_cast<double>(bytes.size()));
        const auto result = read_bytes(bytes.substr(0, size));
        EXPECT_EQ(result.end.kind, Kind::Truncated) << result.end.message;
        EXPECT_LT(result.end.objects_read, objects.size());
    }
}

TEST(RawlogReader, GzFileThatLosesOnlyItsChecksumKeepsAllObjects) {
    const auto objects = small_recording();
    const std::string bytes = gz(serialized(objects));
    const auto result = read_bytes(bytes.substr(0, bytes.size() - 3));
    EXPECT_EQ(result.end.kind, Kind::Truncated) << result.end.message;
    EXPECT_EQ(result.end.objects_read, objects.size());
}

TEST(RawlogReader, WrongChecksumIsCorruptAfterAllObjects) {
    const auto objects = small_recording();
    std::string bytes = gz(serialized(objects));
    bytes[bytes.size() - 6] = static_cast<char>(bytes[bytes.size() - 6] ^ 0x10);
    const auto result = read_bytes(bytes);
    EXPECT_EQ(result.end.kind, Kind::Corrupt);
    EXPECT_EQ(result.end.objects_read, objects.size());
    EXPECT_TRUE(contains(result.end.message, "incorrect checksum")) << result.end.message;
}

TEST(RawlogReader, FlippedBitInTheGzStreamIsCorrupt) {
    const auto objects = small_recording();
    const std::string good = gz(serialized(objects));
    for (const double share : {0.1, 0.4, 0.7, 0.95}) {
        std::string bytes = good;
        bytes[static_cast<std::size_t>(share * static_cast<double>(bytes.size()))] ^= 0x08;
        const auto result = read_bytes(bytes);
        EXPECT_TRUE(result.end.kind == Kind::Corrupt || result.end.kind == Kind::UnknownClass)
            << result.end.message;
        EXPECT_TRUE(contains(result.end.message, "input.rawlog"));
    }
}

TEST(RawlogReader, FlippedPixelOfAPlainFileCannotBeSeen) {
    const auto objects = small_recording();
    std::string bytes = serialized(objects);
    bytes[offset_of(objects, 3) + 1500] ^= 0x01;
    const auto result = read_bytes(bytes);
    EXPECT_EQ(result.end.kind, Kind::Clean) << result.end.message;
    EXPECT_EQ(result.observations.size(), objects.size());
}

TEST(RawlogReader, UnknownClassEndsReadingAndIsNamed) {
    const auto objects = small_recording();
    std::string bytes = serialized(objects);
    const std::size_t name = bytes.find("CObservationOdometry", offset_of(objects, 4));
    bytes.replace(name, 20, "CObservationOdometer");
    const auto result = read_bytes(bytes);
    EXPECT_EQ(result.end.kind, Kind::UnknownClass);
    EXPECT_EQ(result.end.objects_read, 4U);
    EXPECT_TRUE(contains(result.end.message, "CObservationOdometer")) << result.end.message;
}

TEST(RawlogReader, UnknownClassInsideAFrameIsNamedToo) {
    auto frame = std::make_shared<mrpt::obs::CSensoryFrame>();
    frame->insert(odometry_at(5.0, 0));
    std::string bytes = serialized({frame});
    bytes.replace(bytes.find("CObservationOdometry"), 20, "CObservationOdometer");
    const auto result = read_bytes(bytes);
    EXPECT_EQ(result.end.kind, Kind::UnknownClass) << result.end.message;
    EXPECT_TRUE(contains(result.end.message, "CObservationOdometer")) << result.end.message;
}

TEST(RawlogReader, BogusLengthIsCorruptAndAllocatesNothing) {
    const auto objects = small_recording();
    std::string bytes = serialized(objects);
    // Offset of the length of the label, which precedes its text.
    const std::size_t label = bytes.find("ODOMETRY", offset_of(objects, 4));
    for (const int top : {0x80, 0x40, 0x08, 0xFF}) {
        bytes[label - 1] = static_cast<char>(top);
        const auto result = read_bytes(bytes);
        EXPECT_EQ(result.end.kind, Kind::Corrupt) << result.end.message;
        EXPECT_EQ(result.end.objects_read, 4U);
        EXPECT_TRUE(contains(result.end.message, "more than the file holds")) << result.end.message;
    }
}

TEST(RawlogReader, LargeNumbersThatAreNoLengthsAreKept) {
    auto scan = mrpt::obs::CObservation2DRangeScan::Create();
    scan->timestamp = mrpt::Clock::fromDouble(3.0);
    scan->sensorLabel = "LASER";
    scan->aperture = 3.25F;
    scan->maxRange = 81.5F;
    scan->resizeScan(3);
    for (size_t i = 0; i < 3; ++i) scan->setScanRange(i, 1.5F + static_cast<float>(i));
    const auto result = read_bytes(serialized({scan, odometry_at(4, 1)}));
    EXPECT_EQ(result.end.kind, Kind::Clean) << result.end.message;
    ASSERT_EQ(result.observations.size(), 2U);
    const auto& read = dynamic_cast<mrpt::obs::CObservation2DRangeScan&>(*result.observations[0]);
    EXPECT_FLOAT_EQ(read.aperture, 3.25F);
    EXPECT_FLOAT_EQ(read.maxRange, 81.5F);
    EXPECT_FLOAT_EQ(read.getScanRange(2), 3.5F);
}

TEST(RawlogReader, RawColourImagesAreRead) {
    auto image = image_at(1.0);
    image->image = image->image.colorImage();
    mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(true);
    const std::string bytes = serialized({image, odometry_at(2, 0)});
    mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(false);
    const auto result = read_bytes(bytes);
    EXPECT_EQ(result.end.kind, Kind::Clean) << result.end.message;
    EXPECT_EQ(result.observations.size(), 2U);
}

TEST(RawlogReader, ProgressRunsFromZeroToOne) {
    std::vector<mrpt::serialization::CSerializable::ConstPtr> images;
    for (unsigned i = 0; i < 600; ++i) images.push_back(image_at(100.0 + 0.04 * i, i + 1));
    const auto file = test_folder() / "input.rawlog";
    write_bytes(file, gz(serialized(images)));  // 1.8 MB, several buffers
    RawlogReader reader(file);
    double before = reader.progress();
    EXPECT_LT(before, 0.25);
    int half_way = 0;
    for (; reader.next(); before = reader.progress()) {
        EXPECT_GE(reader.progress(), before);
        EXPECT_LE(reader.progress(), 1.0);
        half_way += reader.progress() > 0.25 && reader.progress() < 0.75;
    }
    EXPECT_GT(half_way, 200);
    EXPECT_DOUBLE_EQ(reader.progress(), 1.0);
}

TEST(RawlogReader, SampleRawlogsOfMrptReadToTheirEnd) {
    const std::filesystem::path folder = "/usr/share/mrpt/datasets";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the package mrpt-common is not installed";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".rawlog") continue;
        const auto result = read_all(entry.path());
        EXPECT_EQ(result.end.kind, Kind::Clean) << result.end.message;
        EXPECT_GT(result.observations.size(), 0U) << entry.path();
    }
}

}  // namespace
}  // namespace flownav::io
