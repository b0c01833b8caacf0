#pragma once

#include <linux/can.h>
#include <sys/types.h>

#include <cstdint>
#include <optional>

#include "common/can/can_link.h"

namespace scanway {

/// A frame as the kernel hands it over, and what it says beside it.
struct RawFrame {
  can_frame raw{};
  Utime utime = 0;
  std::optional<std::uint32_t> dropped;  ///< Frames so far.
};

/// Has the kernel keep the times of what `socket` receives. False with errno set: it does not.
bool keep_times(int socket);
/// As recvmsg(2): the number of bytes that came, which is sizeof(can_frame) for a frame.
ssize_t receive_raw(int socket, RawFrame& frame);
/// As send(2). Never raises SIGPIPE.
ssize_t send_raw(int socket, const CanFrame& frame);
/// What a frame says; neither a frame nor an error when it is of 29 bits or without data.
CanLink::Received read_raw(const RawFrame& frame);

}  // namespace scanway
