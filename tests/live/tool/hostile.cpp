#include "tests/live/tool/hostile.h"

#include <string>
#include <vector>

#include "common/bus/channels.h"
#include "common/messages/layout.h"
#include "common/messages/objects.h"

namespace scanway::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

// A message of the type that ends with `length` wherever a length or number can be.
std::vector<Bytes> lies(const Layout& layout) {
  std::vector<Bytes> all;
  for (const std::uint32_t length : {0xFFFFFFFFU, 0x10000000U, 0x40000000U, 0x7FFFFFFFU, 0x80000000U}) {
    for (std::size_t numbers = 0; numbers <= 24; ++numbers) {
      Bytes bytes;
      const auto hash = static_cast<std::uint64_t>(layout.hash);
      for (int i = 7; i >= 0; --i) bytes.push_back(static_cast<std::uint8_t>(hash >> (8 * i)));
      bytes.insert(bytes.end(), numbers, 0);
      for (int i = 3; i >= 0; --i) bytes.push_back(static_cast<std::uint8_t>(length >> (8 * i)));
      all.push_back(bytes);
      bytes.insert(bytes.end(), 900, 1);
      all.push_back(bytes);
    }
  }
  all.push_back({});
  all.push_back(Bytes(7, 0xFF));
  return all;
}

}  // namespace

void send_hostile(Bus& bus) {
  const Layout& piece = *find_layout("scanway.piece_t");
  for (const Channel& channel : kChannels) {
    const Layout& layout = *find_layout(channel.type);
    for (const Bytes& bytes : lies(channel.cut ? piece : layout)) bus.publish(channel.name, bytes, 0);
    if (!channel.cut) continue;
    std::int64_t version = 0;
    for (const Bytes& bytes : lies(layout)) {
      if (!bytes.empty()) publish_object(bus, channel, bytes, "hostile", ++version, 0);
    }
  }
}

}  // namespace scanway::test
