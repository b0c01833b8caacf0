#include "modules/simulator/device/ends/tcp_end.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <cerrno>

#include "common/files/input_error.h"

namespace scanway::simulator {
namespace {

constexpr std::size_t kMostQueued = 1'000'000;

bool would_block() { return errno == EAGAIN || errno == EINTR; }

}  // namespace

TcpEnd::TcpEnd(std::uint16_t port) { listen_on(port); }

void TcpEnd::open() {
  if (!listener_.is_open()) listen_on(port_);
}

void TcpEnd::shut() {
  host_.close();
  listener_.close();
  queued_.clear();
}

void TcpEnd::listen_on(std::uint16_t port) {
  listener_ = FileDescriptor(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  const int on = 1;
  setsockopt(listener_.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  socklen_t size = sizeof address;
  auto* const plain = reinterpret_cast<sockaddr*>(&address);
  if (bind(listener_.get(), plain, size) != 0 || listen(listener_.get(), 4) != 0 ||
      getsockname(listener_.get(), plain, &size) != 0) {
    throw InputError("TCP port " + std::to_string(port) + ": " + reason_of(errno) + "; choose another port");
  }
  port_ = ntohs(address.sin_port);
}

TcpEnd::Heard TcpEnd::hear() {
  Heard heard;
  if (!listener_.is_open()) return heard;
  if (FileDescriptor next(accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)); next.is_open()) {
    const int on = 1;
    setsockopt(next.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    host_ = std::move(next);
    queued_.clear();
    heard.new_host = true;
  }
  if (!host_.is_open()) return heard;
  char bytes[4096];
  const ssize_t count = recv(host_.get(), bytes, sizeof bytes, 0);
  if (count > 0) heard.bytes.assign(bytes, static_cast<std::size_t>(count));
  if (count == 0 || (count < 0 && !would_block())) host_.close();
  flush();
  return heard;
}

bool TcpEnd::say(const std::string& frame) {
  if (queued_.size() + frame.size() > kMostQueued) return false;
  queued_ += frame;
  flush();
  return true;
}

void TcpEnd::flush() {
  std::size_t sent = 0;
  while (host_.is_open() && sent < queued_.size()) {
    const ssize_t count = send(host_.get(), queued_.data() + sent, queued_.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && would_block()) break;
    if (count <= 0) host_.close();
    if (count > 0) sent += static_cast<std::size_t>(count);
  }
  queued_.erase(0, host_.is_open() ? sent : queued_.size());
}

}  // namespace scanway::simulator
