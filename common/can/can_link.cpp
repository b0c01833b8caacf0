#include "common/can/can_link.h"

#include "common/can/can_socket.h"
#include "common/can/unix_can.h"

namespace scanway {

std::unique_ptr<CanLink> open_can(const std::string& name, const std::vector<std::uint16_t>& ids) {
  if (is_pretended_can(name)) return std::make_unique<UnixCan>(name, ids);
  return std::make_unique<CanSocket>(name, ids);
}

std::unique_ptr<CanLink> serve_can(const std::string& name) {
  if (is_pretended_can(name)) return std::make_unique<CanHub>(name);
  return std::make_unique<CanSocket>(name, std::vector<std::uint16_t>{});
}

}  // namespace scanway
