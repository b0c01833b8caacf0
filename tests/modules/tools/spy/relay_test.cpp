#include "modules/tools/spy/relay.h"

#include <vector>

#include <gtest/gtest.h>

#include "common/messages/codec.h"
#include "common/messages/objects.h"
#include "common/random/random.h"
#include "modules/tools/spy/asker.h"
#include "scanway/goal_t.hpp"
#include "scanway/octomap_t.hpp"
#include "scanway/piece_request_t.hpp"

namespace scanway::tools {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Keeps what is published.
class Shelf : public Bus {
 public:
  void publish(std::string_view channel, std::span<const std::uint8_t> bytes, Utime) override {
    published.push_back({std::string(channel), Bytes(bytes.begin(), bytes.end())});
  }
  void subscribe(std::string_view, Handler) override {}

  std::vector<std::pair<std::string, Bytes>> published;
};

Bytes octomap(std::size_t size) {
  Random random(1);
  octomap_t message{};
  message.nbytes = static_cast<std::int32_t>(size);
  message.bt_stream.resize(size);
  for (auto& byte : message.bt_stream) byte = static_cast<std::uint8_t>(random.below(256));
  return encode(message);
}

class RelayTest : public testing::Test {
 protected:
  void take(const std::string& channel, const Bytes& bytes) { traffic.take({channel, bytes}, 0); }
  void take_object(const std::string& channel, const Bytes& object) {
    for (const piece_t& piece : cut(object, "key", ++version, 0)) take(channel, encode(piece));
  }

  Shelf shelf;
  Relay relay{shelf};
  Traffic traffic{1'000'000, [this](const Sighting& sighting) { relay.pass(sighting); }};
  std::int64_t version = 0;
};

TEST_F(RelayTest, PassesMessagesOfAllTypesAndObjectsWhole) {
  const Bytes goal = encode(goal_t{});
  const Bytes foreign(20, 0x77);
  const Bytes map = octomap(100'000);
  take("GOAL", goal);
  take("CAMERA", foreign);
  take_object("OCTOMAP", map);
  const std::vector<std::pair<std::string, Bytes>> expected{{"GOAL", goal}, {"CAMERA", foreign}, {"OCTOMAP", map}};
  EXPECT_EQ(shelf.published, expected);
}

TEST_F(RelayTest, LeavesOutWhatIsBad) {
  Bytes goal = encode(goal_t{});
  goal.pop_back();
  testing::internal::CaptureStderr();
  take("GOAL", goal);
  take("GOAL", goal);
  take("OCTOMAP", goal);
  testing::internal::GetCapturedStderr();
  EXPECT_TRUE(shelf.published.empty());
}

TEST_F(RelayTest, PassesLargeObjectsAsTheirPieces) {
  const Bytes map = octomap(Relay::kMostObjectBytes + 1);
  take_object("OCTOMAP", map);
  const auto pieces = cut(map, "key", 1, 0);
  ASSERT_EQ(shelf.published.size(), pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) EXPECT_EQ(shelf.published[i].second, encode(pieces[i]));
}

TEST(Asker, AsksForWhatItsChannelsSendersHold) {
  Shelf shelf;
  Asker asker(shelf, {"OCTOMAP"});
  SteadyTime now = 0;
  Traffic traffic(1'000'000, [&](const Sighting& sighting) { asker.hear(sighting, now); });
  const auto announce = [&](const std::string& channel) {
    object_index_t index{};
    index.channel = channel;
    index.nobjects = 1;
    index.objects.resize(1);
    index.objects[0].key = "key";
    index.objects[0].version = 1;
    index.objects[0].npieces = 3;
    traffic.take({"OBJECT_INDEX", encode(index)}, now);
  };
  announce("PATH");
  announce("OCTOMAP");
  for (; now < 3'000'000; now += 10'000) asker.ask(now);
  ASSERT_FALSE(shelf.published.empty());
  for (const auto& [channel, bytes] : shelf.published) {
    EXPECT_EQ(channel, "PIECE_REQUEST");
    EXPECT_EQ(decode<piece_request_t>(bytes).channel, "OCTOMAP");
  }
}

}  // namespace
}  // namespace scanway::tools
