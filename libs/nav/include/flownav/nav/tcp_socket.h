#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace flownav::nav {

/// A connection over TCP that never blocks for longer than it is told. Errors throw RobotError.
class TcpSocket {
  public:
    /// Connects. `port`: a number or the name of a service.
    TcpSocket(const std::string& host, const std::string& port, double timeout_s);
    explicit TcpSocket(int connected_file) : file_(connected_file) {}
    ~TcpSocket();
    TcpSocket(TcpSocket&& other) noexcept;
    TcpSocket& operator=(TcpSocket&&) = delete;

    /// All of it, within a second.
    void send(std::string_view bytes) const;

    /// What has arrived, perhaps nothing, and at most so many bytes: a peer that floods must not keep its
    /// reader from its work.
    std::string receive(std::size_t most = receive_max) const;
    static constexpr std::size_t receive_max = 16384;

    /// True when something has arrived (or the connection has ended) before the time is over.
    bool wait(double timeout_s) const;

  private:
    int file_ = -1;
};

/// Takes connections on the loopback interface, or on all of them.
class TcpListener {
  public:
    /// Port 0: the system chooses one.
    explicit TcpListener(int port, bool loopback_only = true);
    ~TcpListener();
    TcpListener(const TcpListener&) = delete;
    TcpListener& operator=(const TcpListener&) = delete;

    int port() const { return port_; }
    bool wait(double timeout_s) const;
    TcpSocket accept() const;

  private:
    int file_ = -1;
    int port_ = 0;
};

}  // namespace flownav::nav
