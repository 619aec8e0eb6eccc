#include "own_base.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace flownav::nav {
namespace {

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The motor controller at the other end of the serial line.
class Controller {
  public:
    Controller() : file_(::posix_openpt(O_RDWR | O_NOCTTY)) {
        ::grantpt(file_);
        ::unlockpt(file_);
    }
    ~Controller() { ::close(file_); }

    std::string device() const { return ::ptsname(file_); }

    void write(const std::string& text) const {
        ASSERT_EQ(::write(file_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }
    std::string read_line() const {
        std::string line;
        for (char c = 0; ::read(file_, &c, 1) == 1 && c != '\n';) line += c;
        return line;
    }

  private:
    int file_;
};

TEST(OwnBase, TheExampleOfTheDocumentationIsTheOneThatIsTested) {
    const std::string example = text_of(std::string(FLOWNAV_SOURCE) + "/share/examples/own_base.h");
    const std::string page = text_of(std::string(FLOWNAV_SOURCE) + "/share/doc/robot.md");
    EXPECT_LT(std::count(example.begin(), example.end(), '\n'), 100);
    EXPECT_NE(page.find("```cpp\n" + example + "```"), std::string::npos);
}

TEST(OwnBase, TheExampleDrivesItsWheels) {
    Controller controller;
    SerialBase base(controller.device());
    base.drive({0.2, 0.5});
    EXPECT_EQ(controller.read_line(), "m 1000 3000");
    base.stop();
    EXPECT_EQ(controller.read_line(), "m 0 0");
}

TEST(OwnBase, TheExampleCountsItsWay) {
    Controller controller;
    SerialBase base(controller.device());
    EXPECT_FALSE(base.odometry());
    const auto reading_after = [&](const std::string& text) {
        controller.write(text);
        std::optional<WheelReading> reading;
        while (!reading) reading = base.odometry();
        return *reading;
    };
    reading_after("e 100 100\n");
    const WheelReading ahead = reading_after("e 5100 5100\n");
    EXPECT_NEAR(ahead.T_odom_robot.x_m, 0.5, 1e-9);
    EXPECT_GT(ahead.motion.v_mps, 0.0);
    const WheelReading left = reading_after("e 4100 6100\n");
    EXPECT_NEAR(left.T_odom_robot.yaw_rad, 0.5, 1e-9);
    EXPECT_GT(left.motion.omega_radps, 0.0);
}

TEST(OwnBase, TheExampleSaysWhenTheRobotIsNotThere) {
    EXPECT_THROW(SerialBase("/dev/no_such_line"), RobotError);
}

}  // namespace
}  // namespace flownav::nav
