#include "flownav/pipeline/repeated_images.h"

#include <gtest/gtest.h>

#include <vector>

namespace flownav::pipeline {
namespace {

/// A small image that owns its pixels.
struct Picture {
    std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(8 * 4, 100);
    ImageView view() const { return {pixels.data(), 7, 4, 8}; }
};

TEST(RepeatedImages, TheFirstImageIsNew) {
    EXPECT_FALSE(RepeatedImages().is_repeated(Picture().view()));
}

TEST(RepeatedImages, OneDifferentPixelIsAnotherImage) {
    RepeatedImages images;
    Picture picture;
    images.is_repeated(picture.view());
    EXPECT_TRUE(images.is_repeated(picture.view()));
    picture.pixels[9] += 1;
    EXPECT_FALSE(images.is_repeated(picture.view()));
}

TEST(RepeatedImages, PixelsBesideTheImageDoNotMatter) {
    RepeatedImages images;
    Picture picture;
    images.is_repeated(picture.view());
    picture.pixels[7] += 1;
    EXPECT_TRUE(images.is_repeated(picture.view()));
}

TEST(RepeatedImages, TheTwoFieldsOfAFrozenFrameTakeTurns) {
    RepeatedImages images;
    Picture upper, lower;
    lower.pixels[12] = 0;
    EXPECT_FALSE(images.is_repeated(upper.view()));
    EXPECT_FALSE(images.is_repeated(lower.view()));
    EXPECT_TRUE(images.is_repeated(upper.view()));
    EXPECT_TRUE(images.is_repeated(lower.view()));
}

TEST(RepeatedImages, AnImageOfLongAgoIsNew) {
    RepeatedImages images;
    Picture picture, second, third;
    second.pixels[0] = 1;
    third.pixels[0] = 2;
    for (const Picture* p : {&picture, &second, &third}) images.is_repeated(p->view());
    EXPECT_FALSE(images.is_repeated(picture.view()));
}

}  // namespace
}  // namespace flownav::pipeline
