#include "flownav/nav/tcp_robot.h"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <thread>

#include "flownav/nav/watchdog.h"
#include "flownav/testing/reference_base.h"

namespace flownav::nav {
namespace {

using testing::ReferenceBase;
using testing::ReferenceBaseOptions;

TcpAddress address_of(int port) {
    return {"127.0.0.1", std::to_string(port)};
}

/// The reference base in its own thread.
class Served {
  public:
    explicit Served(const ReferenceBaseOptions& options = {})
        : base_(options), thread_([this] { base_.serve([this] { return ended_.load(); }); }) {}
    ~Served() {
        ended_ = true;
        thread_.join();
    }

    TcpAddress address() const { return address_of(base_.port()); }

  private:
    std::atomic<bool> ended_ = false;
    ReferenceBase base_;
    std::thread thread_;
};

/// Drives until `enough` accepts a reading; at most some seconds.
template <typename Enough>
bool drive_until(TcpRobot& robot, const std::optional<MotionCommand>& command, const Enough& enough) {
    for (int i = 0; i < 1000; ++i) {
        if (command) robot.drive(*command);
        robot.wait(0.05);
        const std::optional<WheelReading> reading = robot.odometry();
        if (reading && enough(*reading)) return true;
    }
    return false;
}

/// A base that sends fixed lines after the hello.
class Scripted {
  public:
    explicit Scripted(const std::string& lines, bool closes = false)
        : thread_([this, lines, closes] {
              TcpSocket client = listener_.accept_within(30.0);
              client.send(lines);
              if (closes) return;
              while (!ended_) client.wait(0.01);
          }) {}
    ~Scripted() {
        ended_ = true;
        thread_.join();
    }

    TcpAddress address() const { return address_of(listener_.port()); }

  private:
    struct Listener : TcpListener {
        Listener() : TcpListener(0) {}
        TcpSocket accept_within(double timeout_s) {
            if (!wait(timeout_s)) throw RobotError("nobody came");
            return accept();
        }
    };
    std::atomic<bool> ended_ = false;
    Listener listener_;
    std::thread thread_;
};

std::string error_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const RobotError& error) {
        return error.what();
    }
    return {};
}

TEST(TcpRobot, DrivesTheReferenceBase) {
    const Served base;
    TcpRobot robot(base.address());
    EXPECT_EQ(robot.base_timeout_s(), 0.3);
    EXPECT_TRUE(drive_until(robot, MotionCommand{0.4, 0.0},
                            [](const WheelReading& r) { return r.T_odom_robot.x_m > 0.05; }));
    EXPECT_TRUE(drive_until(robot, MotionCommand{0.0, 0.9},
                            [](const WheelReading& r) { return r.T_odom_robot.yaw_rad > 0.1; }));
    robot.stop();
    EXPECT_TRUE(
        drive_until(robot, MotionCommand{}, [](const WheelReading& r) { return r.motion.v_mps == 0.0; }));
    EXPECT_EQ(robot.malformed_lines(), 0);
    EXPECT_EQ(robot.last_complaint(), "");
}

TEST(TcpRobot, ReadingsCarryTheTimeOfOurClock) {
    const Served base;
    TcpRobotParams params;
    double now_s = 5000.0;
    params.clock_s = [&] { return now_s += 1e-4; };
    TcpRobot robot(base.address(), params);
    double last_s = 0.0;
    for (int i = 0; i < 5; ++i) {
        ASSERT_TRUE(drive_until(robot, {}, [&](const WheelReading& r) {
            EXPECT_GT(r.time_s, last_s);
            last_s = r.time_s;
            return true;
        }));
        EXPECT_NEAR(last_s, 5000.0, 10.0);
    }
}

TEST(TcpRobot, ABaseWithoutCommandsStopsByItself) {
    ReferenceBaseOptions options;
    options.timeout_ms = 20;
    const Served base(options);
    TcpRobot robot(base.address());
    robot.drive({0.4, 0.0});
    EXPECT_TRUE(drive_until(robot, {}, [&](const WheelReading& r) {
        return robot.stops_of_base() == 1 && r.motion.v_mps == 0.0;
    }));
}

TEST(TcpRobot, TheWatchdogStopsItFromItsOwnThread) {
    ReferenceBaseOptions options;
    options.timeout_ms = 60000;
    const Served base(options);
    TcpRobot robot(base.address());
    robot.drive({0.4, 0.0});
    ASSERT_TRUE(drive_until(robot, {}, [](const WheelReading& r) { return r.motion.v_mps > 0.05; }));
    Watchdog watchdog([&] { robot.stop(); });
    watchdog.start_watchdog(0.005);  // without calls of alive()
    EXPECT_TRUE(drive_until(robot, {}, [](const WheelReading& r) { return r.motion.v_mps == 0.0; }));
}

TEST(TcpRobot, AnotherMayConnectWhenTheFirstHasGone) {
    const Served base;
    for (int i = 0; i < 3; ++i) {
        TcpRobot robot(base.address());
        EXPECT_TRUE(drive_until(robot, {}, [](const WheelReading&) { return true; }));
    }
}

TEST(TcpRobot, NonsenseOfTheBaseIsCountedAndPassedOver) {
    const Scripted base(
        "hello flownav-base 1 300\nodometry 1 2\nblah\n\xff\xfe\nodometry 1 2 3 0.5 0.1 0.2\nerror no such "
        "line\n");
    TcpRobot robot(base.address());
    std::optional<WheelReading> reading;
    for (int i = 0; i < 100 && robot.last_complaint().empty(); ++i) {
        robot.wait(0.1);
        if (const auto newer = robot.odometry()) reading = newer;
    }
    ASSERT_TRUE(reading);
    EXPECT_EQ(reading->T_odom_robot.y_m, 3.0);
    EXPECT_EQ(reading->motion.omega_radps, 0.2);
    EXPECT_EQ(robot.malformed_lines(), 3);
    EXPECT_EQ(robot.last_complaint(), "no such line");
}

TEST(TcpRobot, ALostConnectionIsAnErrorThatSaysWhatToDo) {
    const Scripted base("hello flownav-base 1 300\n", true);
    TcpRobot robot(base.address());
    const std::string error = error_of([&] {
        for (int i = 0; i < 100; ++i) {
            robot.wait(0.1);
            robot.odometry();
        }
    });
    EXPECT_NE(error.find("closed the connection"), std::string::npos) << error;
    EXPECT_NE(error.find("stops by itself"), std::string::npos) << error;
}

TEST(TcpSocket, AConnectionThatIsClosedWithBytesUnreadIsClosed) {
    const TcpListener listener(0);
    const TcpSocket socket("127.0.0.1", std::to_string(listener.port()), 30.0);
    socket.send("nobody reads this");
    ASSERT_TRUE(listener.wait(30.0));
    EXPECT_TRUE(listener.accept().wait(30.0));
    socket.wait(30.0);
    const std::string error = error_of([&] { socket.receive(); });
    EXPECT_NE(error.find("closed the connection"), std::string::npos) << error;
}

TEST(TcpRobot, ASilentBaseIsLost) {
    const Scripted base("hello flownav-base 1 300\nodometry 1 2");  // repeats half a line without end
    TcpRobotParams params;
    params.silence_s = 0.01;
    TcpRobot robot(base.address(), params);
    const std::string error = error_of([&] {
        for (int i = 0; i < 100; ++i) {
            robot.wait(0.01);
            robot.odometry();
        }
    });
    EXPECT_NE(error.find("silent"), std::string::npos) << error;
}

TEST(TcpSocket, ReadsNoMoreAtATimeThanItIsTold) {
    const TcpListener listener(0);
    const TcpSocket socket("127.0.0.1", std::to_string(listener.port()), 30.0);
    ASSERT_TRUE(listener.wait(30.0));
    const TcpSocket other = listener.accept();
    other.send(std::string(100000, 'x'));
    std::size_t received = 0;
    while (received < 100000) {
        ASSERT_TRUE(socket.wait(30.0));
        const std::size_t size = socket.receive().size();
        EXPECT_LE(size, TcpSocket::receive_max);
        received += size;
    }
    other.send("0123456789");
    ASSERT_TRUE(socket.wait(30.0));
    EXPECT_EQ(socket.receive(4), "0123");
    EXPECT_EQ(socket.receive(4), "4567");
    EXPECT_EQ(socket.receive(4), "89");
}

TEST(TcpRobot, ABaseThatFloodsIsLost) {
    std::string flood = "hello flownav-base 1 300\n";
    for (int i = 0; i < 40000; ++i) flood += "odometry 1 2 3 0.5 0.1 0.2\n";
    const Scripted base(flood);
    TcpRobot robot(base.address());
    const std::string error = error_of([&] {
        for (int i = 0; i < 100000; ++i) {
            robot.wait(1.0);
            robot.odometry();
        }
    });
    EXPECT_NE(error.find("faster than can be read"), std::string::npos) << error;
}

/// Interrupts system calls.
void interrupt(int /*signal*/) {}

TEST(TcpSocket, ASignalDoesNotEndTheWaiting) {
    struct sigaction action {};
    action.sa_handler = interrupt;  // without SA_RESTART
    struct sigaction before {};
    ASSERT_EQ(sigaction(SIGUSR1, &action, &before), 0);
    const TcpListener listener(0);
    const TcpSocket socket("127.0.0.1", std::to_string(listener.port()), 30.0);
    ASSERT_TRUE(listener.wait(30.0));
    const TcpSocket other = listener.accept();
    const pthread_t waiting = pthread_self();
    std::atomic<bool> goes_on{true};
    std::thread disturber([&] {
        for (int i = 0; i < 200 && goes_on; ++i) {
            pthread_kill(waiting, SIGUSR1);
            std::this_thread::yield();
        }
        other.send("at last");
    });
    EXPECT_TRUE(socket.wait(30.0)) << "a signal counted as the end of the time";
    goes_on = false;
    disturber.join();
    sigaction(SIGUSR1, &before, nullptr);
}

TEST(TcpRobot, WhoeverIsNoBaseIsRefused) {
    TcpRobotParams params;
    params.connect_s = 0.2;
    for (const auto& [lines, why] :
         std::vector<std::pair<std::string, std::string>>{{"HTTP/1.1 400 Bad Request\n", "its first line"},
                                                          {"hello flownav-base 9 300\n", "version 9"},
                                                          {"error busy\n", "busy"},
                                                          {std::string(5000, 'x'), "not the program"},
                                                          {"", "no hello"}}) {
        const Scripted base(lines);
        const std::string error = error_of([&] { TcpRobot(base.address(), params); });
        EXPECT_NE(error.find(why), std::string::npos) << error;
    }
}

TEST(TcpRobot, NobodyThereIsAnError) {
    const int port = TcpListener(0).port();  // a port that is free again
    EXPECT_NE(error_of([&] { TcpRobot robot(address_of(port)); }).find("cannot connect"), std::string::npos);
}

TEST(TcpRobot, AddressesAreReadAndExplained) {
    EXPECT_EQ(parse_tcp_address("tcp:robot.local:4242").host, "robot.local");
    EXPECT_EQ(parse_tcp_address("tcp:robot.local:4242").port, "4242");
    EXPECT_EQ(parse_tcp_address("tcp:[::1]:80").host, "::1");
    for (const std::string wrong : {"", "tcp:", "tcp:host", "tcp::1", "tcp:host:", "udp:host:1"})
        EXPECT_THROW(parse_tcp_address(wrong), std::invalid_argument) << wrong;
}

TEST(ClockOffset, TheEarliestArrivalCounts) {
    ClockOffset offset;
    EXPECT_NEAR(offset.update(100.5, 1.0), 99.5, 1e-9);
    EXPECT_NEAR(offset.update(101.1, 2.0), 99.1, 1e-9);  // arrived with less delay
    EXPECT_NEAR(offset.update(102.9, 3.0), 99.1, 1e-3);  // arrived with more delay
}

TEST(ReferenceBase, AnswersNonsenseWithAnErrorAndIgnoresOldCommands) {
    const Served base;
    TcpSocket socket("127.0.0.1", base.address().port, 3.0);
    socket.send("hello flownav-base 1\nrubbish\ndrive 0.4 0 5\ndrive -0.1 0 4\n");
    LineBuffer lines;
    bool complained = false;
    double x_m = 0.0;
    for (int i = 0; i < 1000 && x_m < 0.01; ++i) {
        ASSERT_TRUE(socket.wait(10.0));
        lines.add(socket.receive());
        while (const auto line = lines.next()) {
            const base_protocol::Line parsed = base_protocol::parse(*line);
            complained |= std::holds_alternative<base_protocol::Complaint>(parsed);
            if (const auto* reading = std::get_if<WheelReading>(&parsed)) x_m = reading->T_odom_robot.x_m;
        }
    }
    EXPECT_TRUE(complained);
    EXPECT_GT(x_m, 0.0);  // the older command, backward, was ignored
}

}  // namespace
}  // namespace flownav::nav
