#include <gtest/gtest.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <optional>
#include <random>

#include "flownav/io/field_source.h"
#include "rawlog_files.h"

/// A machine with little memory: what the address sanitizer would otherwise call an error becomes a null
/// pointer, which OpenCV reports as an exception.
extern "C" const char* __asan_default_options();   // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __asan_default_options() {  // NOLINT(bugprone-reserved-identifier)
    return "allocator_may_return_null=1:max_allocation_size_mb=1024";
}

namespace flownav {
namespace {

using namespace flownav::testing;
using Random = std::minstd_rand;

std::size_t below(Random& random, std::size_t limit) {
    return random() % limit;
}

mrpt::obs::CSensoryFrame::Ptr sensory_frame() {
    auto scan = mrpt::obs::CObservation2DRangeScan::Create();
    scan->timestamp = mrpt::Clock::fromDouble(101.0);
    scan->resizeScan(30);
    auto frame = std::make_shared<mrpt::obs::CSensoryFrame>();
    frame->insert(image_at(101.0, 20));
    frame->insert(scan);
    return frame;
}

mrpt::obs::CActionCollection::Ptr action() {
    mrpt::obs::CActionRobotMovement2D movement;
    mrpt::obs::CActionRobotMovement2D::TMotionModelOptions model;
    movement.computeFromOdometry(mrpt::poses::CPose2D(0.5, 0, 0.1), model);
    auto actions = std::make_shared<mrpt::obs::CActionCollection>();
    actions->insert(movement);
    return actions;
}

/// Every kind of object that rawlogs of cameras hold.
std::string recording() {
    auto objects = small_recording();
    auto colour = image_at(101.5, 30);
    colour->image = colour->image.colorImage();
    auto external = image_at(101.6, 31);
    external->image.setExternalStorage("gone.png");
    auto comment = std::make_shared<mrpt::obs::CObservationComment>();
    comment->text = "a comment of some length, as people write them";
    objects.insert(objects.end(), {sensory_frame(), action(), sensory_frame(), colour, external, comment});
    return serialized(objects);
}

void flip_bits(std::string& bytes, Random& random) {
    for (std::size_t i = 1 + below(random, 8); i > 0; --i) {
        char& byte = bytes[below(random, bytes.size())];
        byte = static_cast<char>(byte ^ (1 << below(random, 8)));
    }
}

void overwrite_run(std::string& bytes, Random& random) {
    const std::size_t begin = below(random, bytes.size());
    const std::size_t length = std::min(1 + below(random, 64), bytes.size() - begin);
    const char fill = below(random, 2) == 0 ? '\xFF' : '\0';
    bytes.replace(begin, length, length, fill);
}

void remove_run(std::string& bytes, Random& random) {
    bytes.erase(below(random, bytes.size()), 1 + below(random, 64));
}

void cut(std::string& bytes, Random& random) {
    bytes.resize(1 + below(random, bytes.size() - 1));
}

std::string damaged(std::string bytes, Random& random) {
    switch (below(random, 4)) {
        case 0:
            flip_bits(bytes, random);
            break;
        case 1:
            overwrite_run(bytes, random);
            break;
        case 2:
            remove_run(bytes, random);
            break;
        default:
            cut(bytes, random);
    }
    return bytes;
}

unsigned long sum_of_pixels(const ImageView& image) {
    unsigned long sum = 0;
    for (int v = 0; v < image.height_px; ++v) {
        for (int u = 0; u < image.width_px; ++u) sum += image.at(u, v);
    }
    return sum;
}

/// A field that was read before, and what its pixels added up to then.
struct Kept {
    Field field;
    unsigned long sum = 0;
};

/// The camera is the one of the image, fields come in the order of time, and reading on leaves the pixels of
/// the field before as they were. Looks at every pixel.
void expect_sound(const Field& field, std::optional<Kept>& before) {
    ASSERT_FALSE(field.image.empty());
    EXPECT_EQ(field.image.width_px, field.camera.width_px);
    EXPECT_EQ(field.image.height_px, field.camera.height_px);
    EXPECT_GT(field.camera.fx_px, 0.0);
    EXPECT_GT(field.camera.fy_px, 0.0);
    EXPECT_GT(field.camera.mount.height_m, 0.0);
    if (before) {
        EXPECT_GT(field.timestamp_s, before->field.timestamp_s);
        EXPECT_EQ(sum_of_pixels(before->field.image), before->sum);
    }
    before = {field, sum_of_pixels(field.image)};
}

/// Reads to the end.
io::ReadEnd read_everything(const std::filesystem::path& file) {
    io::RawlogReader reader(file);
    io::FieldSource source(reader, {});
    std::optional<Kept> before;
    while (true) {
        try {
            const auto event = source.next();
            if (!event) return reader.end();
            if (const auto* field = std::get_if<Field>(&*event)) expect_sound(*field, before);
        } catch (const config::ConfigError&) {
            // A damaged calibration; reading can go on.
        }
    }
}

void expect_an_end(const std::string& bytes, const std::string& what) {
    const auto file = test_folder() / "damaged.rawlog";
    write_bytes(file, bytes);
    try {
        const io::ReadEnd end = read_everything(file);
        EXPECT_NE(end.kind, io::ReadEnd::Kind::NotYet) << what;
        EXPECT_EQ(end.message.empty(), end.kind == io::ReadEnd::Kind::Clean) << what;
        EXPECT_LE(end.objects_read, 40U) << what;
    } catch (const io::InputError& e) {
        EXPECT_STRNE(e.what(), "") << what;
    }
}

TEST(DamagedRawlog, PlainFileAlwaysReadsToAnEnd) {
    const std::string good = recording();
    for (unsigned seed = 1; seed <= 400; ++seed) {
        Random random(seed);
        expect_an_end(damaged(good, random), "seed " + std::to_string(seed));
    }
}

TEST(DamagedRawlog, GzFileAlwaysReadsToAnEnd) {
    const std::string good = gz(recording());
    for (unsigned seed = 1; seed <= 400; ++seed) {
        Random random(seed);
        expect_an_end(damaged(good, random), "seed " + std::to_string(seed));
    }
}

TEST(DamagedRawlog, DamageBelowARightChecksumAlwaysReadsToAnEnd) {
    const std::string good = recording();
    for (unsigned seed = 1; seed <= 200; ++seed) {
        Random random(1000 + seed);
        expect_an_end(gz(damaged(good, random)), "seed " + std::to_string(seed));
    }
}

TEST(DamagedRawlog, EveryByteOfAnObjectMayBeDamaged) {
    const std::string good = serialized({image_at(1.0), odometry_at(1.0, 0.5), truth_at(1.0, 0.5)});
    const std::string rest = serialized({image_at(2.0)});
    constexpr std::size_t pixel_count = std::size_t{64} * 48;
    const std::size_t pixels =
        serialized({image_at(1.0)}).size() - pixel_count - 40;  // about where they begin
    for (std::size_t i = 0; i < good.size(); ++i) {
        if (i > pixels && i < pixels + pixel_count - 100) continue;
        std::string bytes = good + rest;
        bytes[i] = static_cast<char>(bytes[i] ^ 0x80);
        expect_an_end(bytes, "byte " + std::to_string(i));
    }
}

TEST(DamagedRawlog, UndamagedRecordingReadsCleanly) {
    const auto file = test_folder() / "good.rawlog";
    write_bytes(file, recording());
    const io::ReadEnd end = read_everything(file);
    EXPECT_EQ(end.kind, io::ReadEnd::Kind::Clean) << end.message;
    EXPECT_EQ(end.objects_read, 30U);
}

}  // namespace
}  // namespace flownav
