#include <gtest/gtest.h>

#include <filesystem>

#include "flownav/testing/presets.h"
#include "score.h"
#include "studio.h"

namespace flownav::fidelity {
namespace {

RenderedScene short_drive(const std::filesystem::path& cache = {}) {
    testing::SceneOptions options = testing::common_preset(3);
    options.camera = testing::standard_camera(320, 240);
    options.images = 32;
    return render_scene("short", options, cache);
}

const RenderedScene& drive() {
    static const RenderedScene rendered = short_drive();
    return rendered;
}

TEST(Evaluate, GoodChainOnACalmCarpetHasSmallErrors) {
    const Score score = evaluate(drive(), {});
    EXPECT_EQ(score.ego.omega_degps.count, 21);  // images 11 to 31
    EXPECT_GT(score.ego.ok.percent(), 90.0);
    EXPECT_LT(score.ego.omega_degps.rms(), 0.3);
    EXPECT_LT(std::abs(score.ego.v_percent.mean()), 1.5);
    EXPECT_EQ(score.ego.covered_most, 0.0);
    EXPECT_GT(score.blocks.false_blocks.all, 2);
    EXPECT_NEAR(score.ego.path_m, 31 * 0.016, 1e-3);
}

TEST(Evaluate, CameraBelievedTooHighMakesTheSpeedTooLarge) {
    const Score score = evaluate(drive(), config_of({"high", {{"camera.height_m", "0.99"}}}));
    const double as_it_is = evaluate(drive(), {}).ego.v_percent.mean();
    EXPECT_NEAR(score.ego.v_percent.mean() - as_it_is, 10.0, 1.0);
}

TEST(Evaluate, OnlyDetectionsBeyondTauCount) {
    const Score blind = evaluate(drive(), config_of({"blind", {{"obstacles.tau_px", "20"}}}));
    EXPECT_EQ(blind.blocks.detected.hits, 0);
    EXPECT_EQ(blind.points.near.all, 0);
    const Score seeing = evaluate(drive(), {});
    EXPECT_GT(seeing.blocks.detected.all, 0);
    EXPECT_GT(seeing.blocks.detected.hits, seeing.blocks.detected.all / 2);
    EXPECT_LE(seeing.blocks.detected.hits, seeing.blocks.detected.all);
}

TEST(Evaluate, TwoDrivesAddUp) {
    const Score once = evaluate(drive(), {});
    Score twice = once;
    twice.add(once);
    EXPECT_EQ(twice.ego.omega_degps.count, 2 * once.ego.omega_degps.count);
    EXPECT_DOUBLE_EQ(twice.ego.omega_degps.rms(), once.ego.omega_degps.rms());
    EXPECT_EQ(twice.blocks.detected.all, 2 * once.blocks.detected.all);
    EXPECT_EQ(twice.points.surface_error_m[1].size(), 2 * once.points.surface_error_m[1].size());
}

TEST(RenderedScene, ComesBackFromItsCacheAndOnlyForTheSameScene) {
    const auto cache = std::filesystem::path(::testing::TempDir()) / "fidelity-cache";
    std::filesystem::remove_all(cache);
    std::filesystem::create_directories(cache);
    const auto pixels = [](const RenderedScene& scene) {
        const ImageView& image = scene.fields.back().image;
        const auto size = static_cast<std::ptrdiff_t>(image.width_px) * image.height_px;
        return std::vector<std::uint8_t>(image.data, image.data + size);
    };
    const auto files = [&] { return std::distance(std::filesystem::directory_iterator(cache), {}); };
    const auto rendered = pixels(short_drive(cache));
    EXPECT_EQ(files(), 1);
    EXPECT_EQ(pixels(short_drive(cache)), rendered);
    EXPECT_EQ(pixels(drive()), rendered);
    EXPECT_EQ(files(), 1);
    testing::SceneOptions noisier = drive().scene.options;
    noisier.effects.noise_sigma = 5.0;
    EXPECT_NE(pixels(render_scene("short", noisier, cache)), rendered);
    EXPECT_EQ(files(), 2);
    std::filesystem::remove_all(cache);
}

TEST(Variants, UnknownKeyIsAnError) {
    EXPECT_THROW(config_of({"wrong", {{"flow.colour", "red"}}}), config::ConfigError);
}

}  // namespace
}  // namespace flownav::fidelity
