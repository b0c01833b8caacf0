#include "common/can/can_socket.h"

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "common/can/raw_frame.h"
#include "common/files/input_error.h"

namespace scanway {
namespace {

std::string how_to_bring_up(const std::string& interface) {
  return "sudo ip link set " + interface + " up type can bitrate 500000";
}

}  // namespace

CanSocket::CanSocket(std::string interface, const std::vector<std::uint16_t>& ids) : interface_(std::move(interface)) {
  if (interface_.empty() || interface_.size() >= IFNAMSIZ) {
    throw InputError("'" + interface_ + "' is no name of a CAN interface; name one, such as can0");
  }
  socket_ = FileDescriptor(socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_RAW));
  if (!socket_.is_open()) {
    if (errno == EAFNOSUPPORT) {
      throw InputError(interface_ + ": this machine's kernel has no CAN: load it with 'sudo modprobe can_raw'");
    }
    fail("no socket", errno);
  }
  ifreq request{};
  std::copy(interface_.begin(), interface_.end(), request.ifr_name);
  if (ioctl(socket_.get(), SIOCGIFINDEX, &request) != 0) {
    throw InputError(interface_ +
                     ": there is no such CAN interface: is the adapter plugged in? ('ip link' lists them)");
  }
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = request.ifr_ifindex;
  if (ioctl(socket_.get(), SIOCGIFFLAGS, &request) != 0) fail("its state cannot be read", errno);
  const bool up = (request.ifr_flags & IFF_UP) != 0;
  set_filters(ids);
  if (bind(socket_.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
    throw InputError(interface_ + ": this is no CAN interface; name one, such as can0");
  }
  if (!up) throw InputError(interface_ + ": the CAN interface is down: " + how_to_bring_up(interface_));
}

void CanSocket::set_filters(const std::vector<std::uint16_t>& ids) {
  if (!ids.empty()) {
    std::vector<can_filter> filters;
    for (const std::uint16_t id : ids) filters.push_back({id, CAN_SFF_MASK | CAN_EFF_FLAG | CAN_RTR_FLAG});
    const auto size = static_cast<socklen_t>(filters.size() * sizeof(can_filter));
    if (setsockopt(socket_.get(), SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(), size) != 0) fail("no filter", errno);
  }
  const can_err_mask_t errors = CAN_ERR_MASK;
  const int on = 1;
  if (setsockopt(socket_.get(), SOL_CAN_RAW, CAN_RAW_ERR_FILTER, &errors, sizeof errors) != 0 ||
      setsockopt(socket_.get(), SOL_SOCKET, SO_RXQ_OVFL, &on, sizeof on) != 0 || !keep_times(socket_.get())) {
    fail("its socket cannot be set up", errno);
  }
}

std::optional<CanLink::Received> CanSocket::receive(int timeout_ms) {
  pollfd waiting{socket_.get(), POLLIN, 0};
  if (poll(&waiting, 1, timeout_ms) <= 0) return std::nullopt;
  RawFrame frame;
  const ssize_t count = receive_raw(socket_.get(), frame);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return std::nullopt;
  if (count < 0) fail("the CAN interface went away", errno);
  if (count != static_cast<ssize_t>(sizeof frame.raw)) return std::nullopt;
  Received received = read_raw(frame);
  received.lost_before = frame.dropped.value_or(dropped_) != dropped_;
  dropped_ = frame.dropped.value_or(dropped_);
  return received;
}

bool CanSocket::send(const CanFrame& frame) {
  if (send_raw(socket_.get(), frame) == static_cast<ssize_t>(sizeof(can_frame))) return true;
  if (errno == ENOBUFS || errno == EAGAIN || errno == EINTR) return false;
  fail("the CAN interface went away", errno);
}

void CanSocket::fail(const std::string& what, int error) const {
  if (error == ENETDOWN) {
    throw InputError(interface_ + ": the CAN interface is down: " + how_to_bring_up(interface_));
  }
  throw InputError(interface_ + ": " + what + ": " + reason_of(error) + "; is the adapter plugged in?");
}

}  // namespace scanway
