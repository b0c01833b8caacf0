#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/can/can_link.h"
#include "common/files/file_descriptor.h"

namespace scanway {

/// An end of a CAN interface of this machine (SocketCAN, CAN_RAW).
class CanSocket : public CanLink {
 public:
  /// Throws as well when the interface is not there or down.
  CanSocket(std::string interface, const std::vector<std::uint16_t>& ids);

  std::optional<Received> receive(int timeout_ms) override;
  bool send(const CanFrame& frame) override;

 private:
  [[noreturn]] void fail(const std::string& what, int error) const;
  void set_filters(const std::vector<std::uint16_t>& ids);

  std::string interface_;
  FileDescriptor socket_;
  std::uint32_t dropped_ = 0;  // As the kernel counts.
};

}  // namespace scanway
