#include "tests/live/tool/hostile.h"

#include <chrono>
#include <thread>

#include "common/bus/channels.h"
#include "common/messages/codec.h"
#include "tests/live/hostile/messages/hostile_messages.h"

namespace scanway::test {
namespace {

constexpr std::size_t kStride = 7;
constexpr std::size_t kContradictions = 200;
constexpr int kRequests = 100;
constexpr std::chrono::microseconds kPause(100);  // Not to drown them: what the kernel drops tries nothing.

}  // namespace

void send_hostile(Bus& bus) {
  Random random(1);
  for (const Channel& channel : kChannels) {
    const auto publish = [&](const Bytes& bytes) {
      bus.publish(channel.name, bytes, 0);
      std::this_thread::sleep_for(kPause * (1 + bytes.size() / 3000));
    };
    const auto publish_piece = [&](const piece_t& piece) { publish(encode(piece)); };
    tell_lies(*find_layout(channel.cut ? std::string_view("scanway.piece_t") : channel.type), random, kStride, publish);
    if (!channel.cut) continue;
    tell_lying_objects(channel, random, kStride, publish_piece);
    // A sweep that never becomes whole keeps the map unsettled until it is given up: tried where time is cheaper.
    if (channel.name == channel::kSweep.name) continue;
    tell_contradictions(random, kContradictions, publish_piece);
  }
  for (int i = 0; i < kRequests; ++i) {
    bus.publish(channel::kPieceRequest.name, hostile_request(random), 0);
    bus.publish(channel::kObjectIndex.name, hostile_index(random), 0);
  }
}

}  // namespace scanway::test
