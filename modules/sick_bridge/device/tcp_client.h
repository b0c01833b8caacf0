#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/files/file_descriptor.h"

namespace scanway::sick {

/// One TCP connection to a device. It does not block (but for looking up a name): it is connecting until it is
/// connected or closed.
class TcpClient {
 public:
  enum class State : std::uint8_t { closed, connecting, connected };

  /// `host` is a name or an address; a name is looked up when connecting.
  TcpClient(std::string host, std::uint16_t port) : host_(std::move(host)), port_(port) {}

  /// Begins to connect; what fails at once is in trouble().
  void connect();
  void close();
  /// Waits at most `timeout_ms` for something to happen: connected, bytes to read, room for bytes to send, an end.
  /// Returns the bytes that came.
  std::vector<std::uint8_t> poll(int timeout_ms);
  /// Queues bytes; poll() sends them.
  void send(std::string_view bytes);

  State state() const { return state_; }
  /// Why the connection closed by itself or could not be made: one line with what to do. Empty if close() was called.
  const std::string& trouble() const { return trouble_; }
  /// "192.168.0.1:2112".
  std::string name() const { return host_ + ':' + std::to_string(port_); }

 private:
  void finish_connecting();
  void send_queued();
  std::vector<std::uint8_t> receive();
  void fail(const std::string& what, int error);

  std::string host_;
  std::uint16_t port_;
  State state_ = State::closed;
  FileDescriptor socket_;
  std::string queued_;
  std::string trouble_;
};

}  // namespace scanway::sick
