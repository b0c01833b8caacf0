#include "common/can/unix_can.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <utility>

#include "common/can/raw_frame.h"
#include "common/files/input_error.h"

namespace scanway {
namespace {

constexpr std::string_view kPrefix = "unix:";
constexpr int kWaitingEnds = 16;

sockaddr_un address_of(const std::string& name) {
  const std::string path = name.substr(kPrefix.size());
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) {
    throw InputError("'" + name + "' names no socket; write unix: and a path of at most " +
                     std::to_string(sizeof address.sun_path - 1) + " bytes");
  }
  path.copy(address.sun_path, path.size());
  return address;
}

FileDescriptor make_socket(const std::string& name) {
  FileDescriptor made(socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!made.is_open()) throw InputError(name + ": no socket: " + reason_of(errno));
  return made;
}

bool connects(const FileDescriptor& socket, const sockaddr_un& address) {
  return connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

bool try_later(ssize_t count) { return count < 0 && (errno == EAGAIN || errno == EINTR || errno == ENOBUFS); }

/// A program that was killed leaves its socket behind.
void remove_left_over(const std::string& name, const sockaddr_un& address) {
  struct stat status {};
  if (lstat(address.sun_path, &status) != 0) return;
  if (!S_ISSOCK(status.st_mode)) throw InputError(name + ": there is a file of another kind; choose another name");
  if (connects(make_socket(name), address) || errno == EAGAIN) {
    throw InputError(name + ": another program serves this bus; stop that one, or choose another name");
  }
  unlink(address.sun_path);
}

}  // namespace

UnixCan::UnixCan(std::string name, std::vector<std::uint16_t> ids)
    : name_(std::move(name)), ids_(std::move(ids)), socket_(make_socket(name_)) {
  const sockaddr_un address = address_of(name_);
  keep_times(socket_.get());
  if (!connects(socket_, address)) {
    throw InputError(name_ + ": no bus is served there: " + reason_of(errno) + "; start the program that pretends it");
  }
}

bool UnixCan::wants(const CanFrame& frame) const {
  return ids_.empty() || std::find(ids_.begin(), ids_.end(), frame.id) != ids_.end();
}

std::optional<CanLink::Received> UnixCan::receive(int timeout_ms) {
  pollfd waiting{socket_.get(), POLLIN, 0};
  for (; poll(&waiting, 1, timeout_ms) > 0; timeout_ms = 0) {
    RawFrame frame;
    const ssize_t count = receive_raw(socket_.get(), frame);
    if (try_later(count)) return std::nullopt;
    if (count <= 0) throw InputError(name_ + ": the bus is served no longer; start the program that pretends it");
    if (count != static_cast<ssize_t>(sizeof frame.raw)) continue;
    Received received = read_raw(frame);
    if (received.error != 0 || (received.frame && wants(*received.frame))) return received;
  }
  return std::nullopt;
}

bool UnixCan::send(const CanFrame& frame) {
  const ssize_t count = send_raw(socket_.get(), frame);
  if (count < 0 && !try_later(count)) {
    throw InputError(name_ + ": the bus is served no longer; start the program that pretends it");
  }
  return count > 0;
}

CanHub::CanHub(std::string name) : name_(std::move(name)), socket_(make_socket(name_)) {
  const sockaddr_un address = address_of(name_);
  remove_left_over(name_, address);
  if (bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      listen(socket_.get(), kWaitingEnds) != 0) {
    throw InputError(name_ + ": the bus cannot be served there: " + reason_of(errno));
  }
}

CanHub::~CanHub() { unlink(address_of(name_).sun_path); }

std::optional<CanLink::Received> CanHub::receive(int timeout_ms) {
  std::vector<pollfd> waiting = {{socket_.get(), POLLIN, 0}};
  for (const FileDescriptor& end : ends_) waiting.push_back({end.get(), POLLIN, 0});
  if (poll(waiting.data(), waiting.size(), timeout_ms) <= 0) return std::nullopt;
  if (waiting.front().revents != 0) admit();
  for (std::size_t i = 1; i < waiting.size(); ++i) {
    if (waiting[i].revents != 0) return receive_from(i - 1);
  }
  return std::nullopt;
}

void CanHub::admit() {
  FileDescriptor end(accept4(socket_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
  if (!end.is_open()) return;
  keep_times(end.get());
  ends_.push_back(std::move(end));
}

std::optional<CanLink::Received> CanHub::receive_from(std::size_t end) {
  RawFrame frame;
  const ssize_t count = receive_raw(ends_[end].get(), frame);
  if (try_later(count)) return std::nullopt;
  if (count <= 0) {
    ends_.erase(ends_.begin() + static_cast<std::ptrdiff_t>(end));
    return std::nullopt;
  }
  if (count != static_cast<ssize_t>(sizeof frame.raw)) return std::nullopt;
  for (std::size_t other = 0; other < ends_.size(); ++other) {
    if (other != end) ::send(ends_[other].get(), &frame.raw, sizeof frame.raw, MSG_NOSIGNAL);
  }
  return read_raw(frame);
}

bool CanHub::send(const CanFrame& frame) {
  // Who is gone is found by receive().
  for (const FileDescriptor& end : ends_) send_raw(end.get(), frame);
  return true;
}

}  // namespace scanway
