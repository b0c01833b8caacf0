#pragma once

#include <cstdint>
#include <string>

#include "common/files/file_descriptor.h"

namespace scanway::simulator {

/// The device's end of a TCP connection: a server on the loopback interface that serves one host at a time; a new host
/// replaces the one before.
class TcpEnd {
 public:
  /// `port` 0: any free one. Throws InputError when the port is taken.
  explicit TcpEnd(std::uint16_t port);

  std::uint16_t port() const { return port_; }
  struct Heard {
    std::string bytes;
    bool new_host = false;  ///< What was said before was said to another one.
  };
  /// What came; does not wait.
  Heard hear();
  bool connected() const { return host_.is_open(); }
  /// Nobody listens here until open(): a host that was connected is cut off, another one is refused.
  void shut();
  /// Again on the same port.
  void open();
  /// Queues a frame and sends what the connection takes. False: the host does not fetch what is sent, and the frame is
  /// dropped as a whole.
  bool say(const std::string& frame);

 private:
  void listen_on(std::uint16_t port);
  void flush();

  std::uint16_t port_ = 0;
  FileDescriptor listener_, host_;
  std::string queued_;
};

}  // namespace scanway::simulator
