#include "modules/sick_bridge/device/tcp_client.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <chrono>
#include <memory>
#include <thread>

namespace scanway::sick {
namespace {

constexpr std::size_t kReadAtOnce = 64 * 1024;

std::string advice(int error) {
  switch (error) {
    case ECONNREFUSED:
      return "; is that the port of the device (2112 or 2111), and has it started?";
    case EHOSTUNREACH:
    case ENETUNREACH:
      return "; check the cable, the power and that this machine has an address in its network";
    case ETIMEDOUT:
      return "; check the address, the cable and the power";
    case ECONNRESET:
    case EPIPE:
      return "; it rebooted, or another program took its only connection";
    default:
      return "";
  }
}

/// A socket that polls, notices a dead peer, and sends small requests at once.
int open_socket(const addrinfo& address) {
  const int socket =
      ::socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, address.ai_protocol);
  if (socket < 0) return socket;
  const int on = 1;
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  setsockopt(socket, SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
  return socket;
}

/// For a closed connection, on which poll() has nothing to wait for.
void pause(int timeout_ms) { std::this_thread::sleep_for(std::chrono::milliseconds(timeout_ms)); }

}  // namespace

void TcpClient::connect() {
  close();
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int error = getaddrinfo(host_.c_str(), std::to_string(port_).c_str(), &wanted, &found);
  if (error != 0) {
    trouble_ = name() + ": " + gai_strerror(error) + "; check the name of the device";
    return;
  }
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses(found, freeaddrinfo);
  socket_ = FileDescriptor(open_socket(*addresses));
  state_ = State::connecting;
  if (::connect(socket_.get(), addresses->ai_addr, addresses->ai_addrlen) != 0 && errno != EINPROGRESS) {
    fail("no connection", errno);
  }
}

void TcpClient::close() {
  socket_.close();
  state_ = State::closed;
  queued_.clear();
  trouble_.clear();
}

std::vector<std::uint8_t> TcpClient::poll(int timeout_ms) {
  if (state_ == State::closed) {
    pause(timeout_ms);
    return {};
  }
  const bool wants_to_send = state_ == State::connecting || !queued_.empty();
  pollfd waiting{socket_.get(), static_cast<short>(POLLIN | (wants_to_send ? POLLOUT : 0)), 0};
  if (::poll(&waiting, 1, timeout_ms) <= 0) return {};
  if (state_ == State::connecting) finish_connecting();
  if (state_ == State::connected && (waiting.revents & POLLOUT) != 0) send_queued();
  if (state_ == State::connected && (waiting.revents & (POLLIN | POLLHUP | POLLERR)) != 0) return receive();
  return {};
}

void TcpClient::send(std::string_view bytes) { queued_ += bytes; }

void TcpClient::finish_connecting() {
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(socket_.get(), SOL_SOCKET, SO_ERROR, &error, &size);
  if (error != 0) return fail("no connection", error);
  state_ = State::connected;
}

void TcpClient::send_queued() {
  const ssize_t count = ::send(socket_.get(), queued_.data(), queued_.size(), MSG_NOSIGNAL);
  if (count > 0) {
    queued_.erase(0, static_cast<std::size_t>(count));
  } else if (count < 0 && errno != EAGAIN && errno != EINTR) {
    fail("the connection is gone", errno);
  }
}

std::vector<std::uint8_t> TcpClient::receive() {
  std::vector<std::uint8_t> bytes(kReadAtOnce);
  const ssize_t count = recv(socket_.get(), bytes.data(), bytes.size(), 0);
  if (count == 0) {
    fail("the device closed the connection", 0);
  } else if (count < 0 && errno != EAGAIN && errno != EINTR) {
    fail("the connection is gone", errno);
  }
  bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return bytes;
}

void TcpClient::fail(const std::string& what, int error) {
  close();
  trouble_ = name() + ": " + what;
  if (error != 0) trouble_ += ": " + reason_of(error) + advice(error);
}

}  // namespace scanway::sick
