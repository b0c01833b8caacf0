#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/can/can_link.h"
#include "common/files/file_descriptor.h"

namespace scanway {

/// An end of a bus that another program pretends (CanHub), for machines whose kernel has no CAN.
class UnixCan : public CanLink {
 public:
  /// `name`: "unix:/path".
  UnixCan(std::string name, std::vector<std::uint16_t> ids);

  std::optional<Received> receive(int timeout_ms) override;
  bool send(const CanFrame& frame) override;

 private:
  bool wants(const CanFrame& frame) const;

  std::string name_;
  std::vector<std::uint16_t> ids_;
  FileDescriptor socket_;
};

/// A pretended bus: what one end sends, every other end gets, and so does who holds the hub. An end that does not fetch
/// its frames loses the newest.
class CanHub : public CanLink {
 public:
  /// Makes the socket of `name`, "unix:/path", unless somebody serves it already.
  explicit CanHub(std::string name);
  ~CanHub() override;
  CanHub(const CanHub&) = delete;
  CanHub& operator=(const CanHub&) = delete;

  std::optional<Received> receive(int timeout_ms) override;
  bool send(const CanFrame& frame) override;

 private:
  void admit();
  std::optional<Received> receive_from(std::size_t end);

  std::string name_;
  FileDescriptor socket_;
  std::vector<FileDescriptor> ends_;
};

}  // namespace scanway
