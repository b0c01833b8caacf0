#pragma once

#include <linux/can.h>
#include <linux/can/raw.h>
#include <linux/sockios.h>
#include <net/if.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "common/time/utime.h"
#include "tests/modules/schunk_bridge/support/test_module.h"

namespace scanway::test {

/// A plain CAN socket on vcan0 that has nothing of the bridge's.
class PlainSocket {
 public:
  PlainSocket() : socket_(socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK, CAN_RAW)) {
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(if_nametoindex("vcan0"));
    if (socket_ >= 0) bound_ = bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
    last_time();  // From the first time that it is asked, the kernel keeps times.
  }
  ~PlainSocket() {
    if (socket_ >= 0) close(socket_);
  }
  PlainSocket(const PlainSocket&) = delete;
  PlainSocket& operator=(const PlainSocket&) = delete;

  bool usable() const { return bound_ && if_nametoindex("vcan0") != 0; }

  bool receive(TestFrame& frame, int timeout_ms) {
    pollfd waiting{socket_, POLLIN, 0};
    can_frame raw{};
    if (poll(&waiting, 1, timeout_ms) <= 0 || read(socket_, &raw, sizeof raw) != sizeof raw) return false;
    frame = {static_cast<std::uint16_t>(raw.can_id & CAN_SFF_MASK), {raw.data, raw.data + raw.len}};
    return true;
  }

  /// When the kernel got the frame that was received last.
  Utime last_time() const {
    timeval time{};
    ioctl(socket_, SIOCGSTAMP, &time);
    return time.tv_sec * kMicrosecondsPerSecond + time.tv_usec;
  }

  void send(const TestFrame& frame) {
    can_frame raw{};
    raw.can_id = frame.id;
    raw.len = static_cast<std::uint8_t>(frame.bytes.size());
    std::copy(frame.bytes.begin(), frame.bytes.end(), raw.data);
    while (write(socket_, &raw, sizeof raw) < 0 && errno == ENOBUFS) usleep(200);
  }

 private:
  int socket_;
  bool bound_ = false;
};

}  // namespace scanway::test
