#include "sensor_setup.h"

#include <gtest/gtest.h>

#include <fstream>

#include "flownav/cli/usage_error.h"
#include "grab_samples.h"

namespace flownav {
namespace {

TEST(SensorSetup, ASentenceOfMrptLosesItsMarksAndItsStack) {
    EXPECT_EQ(plain_sentence("==== MRPT exception ====\nMessage:  It broke.\nLocation: a.cpp:1\n[0] 0x1"),
              "It broke.");
    EXPECT_EQ(plain_sentence("==== MRPT exception ====\nIt broke.\nCall stack backtrace:\n"), "It broke.");
    EXPECT_EQ(plain_sentence("It broke."), "It broke.");
    EXPECT_EQ(plain_sentence(""), "an error without a message");
}

TEST(SensorSetup, TheFileOfTheUserStaysAsItIs) {
    const auto file = testing::grab_test_folder() / "grab.ini";
    const std::string text = "; mine\n[global]\nrawlog_GZ_compress_level=3 // small\n";
    std::ofstream(file) << text;
    EXPECT_THROW(read_grab_setup(file), cli::UsageError) << "no sensor";
    std::ifstream stream(file);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), text);
}

TEST(SensorSetup, AFolderIsNoConfiguration) {
    EXPECT_THROW(read_grab_setup(testing::grab_test_folder()), cli::UsageError);
}

}  // namespace
}  // namespace flownav
