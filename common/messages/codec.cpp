#include "common/messages/codec.h"

#include "common/messages/digest.h"

namespace scanway {

void check_message(std::int64_t hash, std::span<const std::uint8_t> bytes) {
  const Layout* const layout = find_layout(hash);
  if (layout == nullptr) throw BadMessage("no layout for fingerprint " + hex(static_cast<std::uint64_t>(hash)));
  const std::string fault = find_fault(*layout, bytes);
  if (!fault.empty()) throw BadMessage(fault);
}

}  // namespace scanway
