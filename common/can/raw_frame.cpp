#include "common/can/raw_frame.h"

#include <sys/socket.h>
#include <sys/time.h>

#include <algorithm>
#include <cstring>

namespace scanway {
namespace {

void read_beside(msghdr& message, RawFrame& frame) {
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr; part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level != SOL_SOCKET) continue;
    if (part->cmsg_type == SO_TIMESTAMP) {
      timeval time;
      std::memcpy(&time, CMSG_DATA(part), sizeof time);
      frame.utime = time.tv_sec * kMicrosecondsPerSecond + time.tv_usec;
    } else if (part->cmsg_type == SO_RXQ_OVFL) {
      frame.dropped.emplace();
      std::memcpy(&*frame.dropped, CMSG_DATA(part), sizeof *frame.dropped);
    }
  }
}

}  // namespace

bool keep_times(int socket) {
  const int on = 1;
  return setsockopt(socket, SOL_SOCKET, SO_TIMESTAMP, &on, sizeof on) == 0;
}

ssize_t receive_raw(int socket, RawFrame& frame) {
  alignas(cmsghdr) char beside[256];
  iovec place{&frame.raw, sizeof frame.raw};
  msghdr message{};
  message.msg_iov = &place;
  message.msg_iovlen = 1;
  message.msg_control = beside;
  message.msg_controllen = sizeof beside;
  const ssize_t count = recvmsg(socket, &message, 0);
  if (count > 0) read_beside(message, frame);
  return count;
}

ssize_t send_raw(int socket, const CanFrame& frame) {
  can_frame raw{};
  raw.can_id = frame.id;
  raw.len = frame.size;
  std::copy(frame.data.begin(), frame.data.end(), raw.data);
  return send(socket, &raw, sizeof raw, MSG_NOSIGNAL);
}

CanLink::Received read_raw(const RawFrame& frame) {
  CanLink::Received received;
  received.utime = frame.utime;
  const can_frame& raw = frame.raw;
  if (raw.can_id & CAN_ERR_FLAG) {
    received.error = raw.can_id & CAN_ERR_MASK;
  } else if (!(raw.can_id & (CAN_EFF_FLAG | CAN_RTR_FLAG))) {
    CanFrame data;
    data.id = static_cast<std::uint16_t>(raw.can_id & CAN_SFF_MASK);
    data.size = std::min<std::uint8_t>(raw.len, 8);
    std::copy_n(raw.data, data.size, data.data.begin());
    received.frame = data;
  }
  return received;
}

}  // namespace scanway
