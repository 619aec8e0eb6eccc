#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace flownav::nav {

/// A TCP connection whose calls block no longer than their timeout. Errors throw RobotError.
class TcpSocket {
  public:
    /// Connects. `port`: a number or the name of a service.
    TcpSocket(const std::string& host, const std::string& port, double timeout_s);
    explicit TcpSocket(int connected_file) : file_(connected_file) {}
    ~TcpSocket();
    TcpSocket(TcpSocket&& other) noexcept;
    TcpSocket& operator=(TcpSocket&&) = delete;

    /// Sends all bytes within a second.
    void send(std::string_view bytes) const;

    /// Returns the bytes that have arrived, at most `most`; may be empty. The limit keeps a flooding peer
    /// from blocking its reader.
    std::string receive(std::size_t most = receive_max) const;
    static constexpr std::size_t receive_max = 16384;

    /// Waits until bytes arrive or the connection ends. Returns false on timeout.
    bool wait(double timeout_s) const;

  private:
    int file_ = -1;
};

/// Accepts connections on the loopback interface, or on all interfaces.
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
