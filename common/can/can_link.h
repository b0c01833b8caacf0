#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/bytes/can_frame.h"
#include "common/time/utime.h"

namespace scanway {

/// One end of a CAN bus. Every error is an InputError of one line that names the bus and says what to do; after an
/// error of receive() or send() the end is of no use any more.
class CanLink {
 public:
  struct Received {
    std::optional<CanFrame> frame;
    std::uint32_t error = 0;   ///< Instead of a frame: the classes of an error frame (linux/can/error.h).
    Utime utime = 0;           ///< When the kernel got it.
    bool lost_before = false;  ///< Frames before it were dropped, since nobody fetched them in time.
  };

  virtual ~CanLink() = default;
  /// Waits at most `timeout_ms` for a frame. Frames that are not of 11 bits with data are passed over.
  virtual std::optional<Received> receive(int timeout_ms) = 0;
  /// Hands a frame to the bus. False: its queue is full, since nobody takes the frames off it.
  virtual bool send(const CanFrame& frame) = 0;
};

/// The bus of that name: "can0" is an interface of this machine (SocketCAN), "unix:/path" a socket on which another
/// program pretends to be a bus (CanHub): each message is one struct can_frame, 16 bytes. Hears the frames with these
/// identifiers, all if there are none, and error frames. Throws when it cannot be used.
std::unique_ptr<CanLink> open_can(const std::string& name, const std::vector<std::uint16_t>& ids = {});

/// The same for who pretends to be a device: of "unix:/path" it is the bus itself, on which others open ends.
std::unique_ptr<CanLink> serve_can(const std::string& name);

/// Whether the name is one of a pretended bus.
inline bool is_pretended_can(std::string_view name) { return name.starts_with("unix:"); }

}  // namespace scanway
