// A robot base of one's own: own_base DEVICE drives the base of own_base.h 0.2 m straight ahead, and prints
// where its wheels say it is, in metres.
#include "own_base.h"

#include <exception>
#include <thread>

int main(int argc, char** argv) try {
    if (argc != 2) throw std::invalid_argument("usage: own_base DEVICE");
    SerialBase base(argv[1]);
    flownav::Pose2 pose;
    while (pose.x_m < 0.2) {
        base.drive({0.2, 0.0});
        if (const auto reading = base.odometry()) pose = reading->T_odom_robot;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    base.stop();
    std::printf("x %.2f m, y %.2f m\n", pose.x_m, pose.y_m);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
