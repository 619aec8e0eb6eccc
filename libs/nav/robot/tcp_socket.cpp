#include "flownav/nav/tcp_socket.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>

#include "flownav/nav/robot_base.h"

namespace flownav::nav {
namespace {

constexpr double send_timeout_s = 1.0;

[[noreturn]] void fail(const std::string& what, int error = errno) {
    throw RobotError(what + ": " + std::strerror(error));
}

using SteadyTime = std::chrono::steady_clock;

/// Waits for `events`. Returns false on timeout; continues waiting after a signal.
bool ready(int file, short events, double timeout_s) {
    const auto end = SteadyTime::now() + std::chrono::duration_cast<SteadyTime::duration>(
                                             std::chrono::duration<double>(std::max(0.0, timeout_s)));
    while (true) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - SteadyTime::now());
        pollfd poll_file{file, events, 0};
        const int files = ::poll(&poll_file, 1, static_cast<int>(std::max<std::int64_t>(0, left.count())));
        if (files > 0) return true;
        if (files == 0 && SteadyTime::now() >= end) return false;
        if (files < 0 && errno != EINTR) fail("cannot wait for the other side");
    }
}

void prepare(int file) {
    const int yes = 1;
    ::setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    ::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) | O_NONBLOCK);
}

/// Returns a connected file descriptor, or -1 with errno set.
int connect_to(const addrinfo& address, double timeout_s) {
    const int file = ::socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (file < 0) return -1;
    prepare(file);
    int error = ::connect(file, address.ai_addr, address.ai_addrlen) == 0 ? 0 : errno;
    if (error == EINPROGRESS) {
        error = ETIMEDOUT;
        socklen_t size = sizeof error;
        if (ready(file, POLLOUT, timeout_s)) ::getsockopt(file, SOL_SOCKET, SO_ERROR, &error, &size);
    }
    if (error == 0) return file;
    ::close(file);
    errno = error;
    return -1;
}

}  // namespace

TcpSocket::TcpSocket(const std::string& host, const std::string& port, double timeout_s) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (const int error = ::getaddrinfo(host.c_str(), port.c_str(), &hints, &found)) {
        throw RobotError("tcp:" + host + ":" + port + " is no address: " + ::gai_strerror(error));
    }
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> addresses(found, &::freeaddrinfo);
    for (const addrinfo* a = found; a != nullptr && file_ < 0; a = a->ai_next)
        file_ = connect_to(*a, timeout_s);
    if (file_ < 0) fail("cannot connect to tcp:" + host + ":" + port);
}

TcpSocket::~TcpSocket() {
    if (file_ >= 0) ::close(file_);
}

TcpSocket::TcpSocket(TcpSocket&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

void TcpSocket::send(std::string_view bytes) const {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(file_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(sent));
        } else if (errno != EAGAIN && errno != EINTR) {
            fail("cannot send");
        } else if (!ready(file_, POLLOUT, send_timeout_s)) {
            fail("cannot send", ETIMEDOUT);
        }
    }
}

std::string TcpSocket::receive(std::size_t most) const {
    std::string bytes;
    std::array<char, 4096> buffer{};
    while (bytes.size() < most) {
        const ssize_t size = ::recv(file_, buffer.data(), std::min(buffer.size(), most - bytes.size()), 0);
        if (size > 0) {
            bytes.append(buffer.data(), static_cast<std::size_t>(size));
            continue;
        }
        if (size < 0 && errno == EINTR) continue;
        if (size < 0 && errno == EAGAIN) return bytes;
        if (!bytes.empty()) return bytes;  // delivers the bytes before the end first
        // ECONNRESET: the peer closed the connection with unread bytes of ours.
        if (size == 0 || errno == ECONNRESET) throw RobotError("the other side closed the connection");
        fail("cannot receive");
    }
    return bytes;
}

bool TcpSocket::wait(double timeout_s) const {
    return ready(file_, POLLIN, timeout_s);
}

TcpListener::TcpListener(int port, bool loopback_only) {
    file_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (file_ < 0) fail("cannot open a socket");
    const int yes = 1;
    ::setsockopt(file_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(loopback_only ? INADDR_LOOPBACK : INADDR_ANY);
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    socklen_t size = sizeof address;
    if (::bind(file_, generic, size) != 0 || ::listen(file_, 4) != 0 ||
        ::getsockname(file_, generic, &size) != 0) {
        const int error = errno;
        ::close(file_);
        fail("cannot listen on port " + std::to_string(port), error);
    }
    port_ = ntohs(address.sin_port);
}

TcpListener::~TcpListener() {
    ::close(file_);
}

bool TcpListener::wait(double timeout_s) const {
    return ready(file_, POLLIN, timeout_s);
}

TcpSocket TcpListener::accept() const {
    const int file = ::accept(file_, nullptr, nullptr);
    if (file < 0) fail("cannot accept a connection");
    prepare(file);
    return TcpSocket(file);
}

}  // namespace flownav::nav
