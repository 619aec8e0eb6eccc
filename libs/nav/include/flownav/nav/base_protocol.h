#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "flownav/nav/robot_base.h"

namespace flownav::nav {

/// The lines exchanged with the program of a base; share/doc/robot.md documents them. Numbers are decimal,
/// with a point; units are seconds, metres, radians.
namespace base_protocol {

constexpr int version = 1;
constexpr std::size_t line_max = 200;  ///< bytes, without the newline

struct Hello {
    int version = 0;
    int timeout_ms = 0;  ///< the base stops by itself after this time without a command; 0: sent by flownav
};
struct Drive {
    MotionCommand command;
    long sequence = 0;
};
struct Stopped {};  ///< the base stopped by itself because no command came in time
struct Complaint {
    std::string text;
};
struct Bye {};
struct Malformed {
    std::string why;
};

using Line = std::variant<Hello, Drive, WheelReading, Stopped, Complaint, Bye, Malformed>;

/// Parses a line without its newline (a trailing \r is ignored). Never throws: an unreadable line is
/// Malformed.
Line parse(std::string_view line);

std::string text(const Hello& hello);
std::string text(const Drive& drive);
std::string text(const WheelReading& reading);
std::string text(const Stopped& stopped);
std::string text(const Complaint& complaint);
std::string text(const Bye& bye);

}  // namespace base_protocol

/// Splits a stream of bytes into lines.
class LineBuffer {
  public:
    void add(std::string_view bytes) { bytes_ += bytes; }

    /// The next complete line, without its newline; empty when there is none yet.
    std::optional<std::string> next();

    /// True when the bytes without a newline exceed line_max: the peer speaks another protocol.
    bool is_overlong() const {
        return bytes_.size() > base_protocol::line_max && bytes_.find('\n') == std::string::npos;
    }

  private:
    std::string bytes_;
};

}  // namespace flownav::nav
