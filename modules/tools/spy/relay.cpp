#include "modules/tools/spy/relay.h"

#include <spdlog/spdlog.h>

#include "common/files/printable.h"

namespace scanway::tools {

using Kind = Sighting::Kind;

void Relay::pass(const Sighting& sighting) {
  const bool large =
      sighting.piece != nullptr && sighting.piece->total_bytes > static_cast<std::int64_t>(kMostObjectBytes);
  switch (sighting.kind) {
    case Kind::message:
    case Kind::foreign:
      return to_.publish(sighting.channel, sighting.bytes, 0);
    case Kind::piece:
      if (large) to_.publish(sighting.channel, sighting.bytes, 0);
      return;
    case Kind::object:
      if (!large) to_.publish(sighting.channel, sighting.bytes, 0);
      return;
    case Kind::bad:
      break;
  }
  if (told_.size() < Traffic::kMostChannels && told_.emplace(sighting.channel).second) {
    spdlog::warn("left out what is bad on {}: {}", printable(sighting.channel), printable(sighting.reason));
  }
}

}  // namespace scanway::tools
