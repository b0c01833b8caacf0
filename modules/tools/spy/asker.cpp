#include "modules/tools/spy/asker.h"

#include "common/bus/channels.h"
#include "common/messages/codec.h"

namespace scanway::tools {

Asker::Asker(Bus& bus, const std::vector<std::string>& channels)
    : channels_(channels.begin(), channels.end()), receiver_([&bus](const piece_request_t& request) {
        bus.publish(channel::kPieceRequest.name, encode(request), request.utime);
      }) {}

void Asker::hear(const Sighting& sighting, SteadyTime now) {
  if (channels_.empty()) return;
  if (sighting.kind == Sighting::Kind::piece && channels_.contains(sighting.channel)) {
    receiver_.add(sighting.channel, *sighting.piece, now);
  } else if (sighting.kind == Sighting::Kind::message && sighting.channel == channel::kObjectIndex.name) {
    const auto index = decode<object_index_t>(sighting.bytes);
    if (channels_.contains(index.channel)) receiver_.hear(index, now);
  }
}

void Asker::ask(SteadyTime now) {
  if (!channels_.empty()) receiver_.ask(now);
}

}  // namespace scanway::tools
