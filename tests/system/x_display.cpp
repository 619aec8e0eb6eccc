#include "x_display.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace flownav::testing {
namespace {

/// Reads the number of the display, which Xvfb writes when it is ready; empty when Xvfb could not start.
std::string read_line(int descriptor) {
    std::string line;
    for (char c = 0; ::read(descriptor, &c, 1) == 1 && c != '\n';) line += c;
    return line;
}

[[noreturn]] void become_xvfb(int ready, const std::string& folder) {
    // CMake provides the path of Xvfb. The option -terminate ends the server when its last client ends, also
    // after a crash of the test.
    const std::string number = std::to_string(ready);
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDERR_FILENO);
    ::execlp(FLOWNAV_XVFB, "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1600x1200x24", "-fbdir",
             folder.c_str(), "-nolisten", "tcp", "-terminate", nullptr);
    ::_exit(127);
}

/// A 32-bit number of an XWD header, most significant byte first.
std::uint32_t number_at(const std::vector<char>& bytes, std::size_t index) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<std::uint8_t>(bytes.at(4 * index + i));
    return value;
}

}  // namespace

std::unique_ptr<XDisplay> XDisplay::start(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    std::array<int, 2> ready{};
    if (::pipe(ready.data()) != 0) return nullptr;
    const pid_t process = ::fork();
    if (process == 0) {
        ::close(ready[0]);
        become_xvfb(ready[1], folder.string());
    }
    ::close(ready[1]);
    const std::string number = read_line(ready[0]);
    ::close(ready[0]);
    std::unique_ptr<XDisplay> display(new XDisplay(process, ':' + number, folder / "Xvfb_screen0"));
    return number.empty() ? nullptr : std::move(display);
}

XDisplay::~XDisplay() {
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
}

cv::Mat XDisplay::screenshot() const {
    std::ifstream stream(file_, std::ios::binary);
    std::vector<char> bytes((std::istreambuf_iterator<char>(stream)), {});
    // Positions in the header of an XWD file.
    constexpr std::size_t header_size = 0, width = 4, height = 5, bytes_per_line = 12, colours = 19;
    constexpr std::size_t colour_bytes = 12;
    const std::size_t begin = number_at(bytes, header_size) + colour_bytes * number_at(bytes, colours);
    const cv::Mat bgra(static_cast<int>(number_at(bytes, height)), static_cast<int>(number_at(bytes, width)),
                       CV_8UC4, bytes.data() + begin, number_at(bytes, bytes_per_line));
    cv::Mat bgr;
    cv::cvtColor(bgra, bgr, cv::COLOR_BGRA2BGR);
    return bgr;
}

}  // namespace flownav::testing
