#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <functional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "common/files/file_descriptor.h"
#include "modules/sick_bridge/device/lms_device.h"

namespace scanway::test {

/// A device on the loopback interface, in this process: `answer` says what it sends for what it gets.
class LoopbackServer {
 public:
  using Answer = std::function<std::string(const std::string&)>;

  explicit LoopbackServer(Answer answer, std::uint16_t port = 0) : answer_(std::move(answer)), port_(port) { listen(); }

  std::uint16_t port() const { return port_; }
  sick::LmsAddress address() const { return {"127.0.0.1", port_}; }

  void run() {
    if (!client_.is_open()) client_ = FileDescriptor(accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK));
    if (!client_.is_open()) return;
    char bytes[4096];
    const ssize_t count = recv(client_.get(), bytes, sizeof bytes, 0);
    if (count == 0) client_.close();
    if (count > 0) send(answer_({bytes, static_cast<std::size_t>(count)}));
  }

  void send(const std::string& bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
      const ssize_t count = ::send(client_.get(), bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
      if (count <= 0) break;
      at += static_cast<std::size_t>(count);
    }
  }

  void hang_up() { client_.close(); }
  /// As when the cable is out, or the device has no power yet.
  void unplug() {
    client_.close();
    listener_.close();
  }
  void plug_in() { listen(); }

 private:
  void listen() {
    listener_ = FileDescriptor(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    const int on = 1;
    setsockopt(listener_.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port_);
    socklen_t size = sizeof address;
    if (bind(listener_.get(), reinterpret_cast<sockaddr*>(&address), size) != 0 || ::listen(listener_.get(), 4) != 0 ||
        getsockname(listener_.get(), reinterpret_cast<sockaddr*>(&address), &size) != 0) {
      ADD_FAILURE() << "no socket on the loopback interface";
    }
    port_ = ntohs(address.sin_port);
  }

  Answer answer_;
  std::uint16_t port_;
  FileDescriptor listener_, client_;
};

}  // namespace scanway::test
