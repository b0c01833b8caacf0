#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/files/file_descriptor.h"
#include "common/time/utime.h"
#include "modules/schunk_bridge/core/can_frame.h"

namespace scanway::schunk {

/// A CAN interface of this machine (SocketCAN, CAN_RAW). Every error is an InputError of one line that names the
/// interface and says what to do; after an error of receive() or send() the socket is of no use any more.
class CanSocket {
 public:
  /// Hears the frames with these identifiers, all if there are none, and the interface's error frames. Throws as well
  /// when the interface is not there or down.
  CanSocket(std::string interface, const std::vector<std::uint16_t>& ids);

  struct Received {
    std::optional<CanFrame> frame;
    std::string trouble;       ///< What an error frame says, instead of a frame.
    Utime utime = 0;           ///< When the kernel got it.
    bool lost_before = false;  ///< Frames before it were dropped, since nobody fetched them in time.
  };
  /// Waits at most `timeout_ms` for a frame. Frames that are not of 11 bits with data are passed over.
  std::optional<Received> receive(int timeout_ms);

  /// Hands a frame to the interface. False: its queue is full, since nobody takes the frames off it.
  bool send(const CanFrame& frame);

  const std::string& interface() const { return interface_; }
  int descriptor() const { return socket_.get(); }

 private:
  [[noreturn]] void fail(const std::string& what, int error) const;
  void set_filters(const std::vector<std::uint16_t>& ids);

  std::string interface_;
  FileDescriptor socket_;
  std::uint32_t dropped_ = 0;  // As the kernel counts.
};

}  // namespace scanway::schunk
