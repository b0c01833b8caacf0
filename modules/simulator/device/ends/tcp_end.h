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
  /// Queues a frame and sends what the connection takes. False: the host does not fetch what is sent, and the frame is
  /// dropped as a whole.
  bool say(const std::string& frame);

 private:
  void flush();

  std::uint16_t port_;
  FileDescriptor listener_, host_;
  std::string queued_;
};

}  // namespace scanway::simulator
