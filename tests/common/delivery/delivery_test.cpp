// A sender and receivers on a wire that loses, repeats and disorders, with a clock that the test turns.
#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/bus/channels.h"
#include "common/bus/memory_bus.h"
#include "common/delivery/object_receiver.h"
#include "common/delivery/object_sender.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"
#include "common/messages/objects.h"
#include "common/random/random.h"

namespace scanway {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr SteadyTime kTick = 10'000;
constexpr SteadyTime kSecond = 1'000'000;
const std::string kChannel(channel::kCloudTile.name);

Bytes random_object(Random& random, std::size_t size) {
  Bytes bytes(size);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
  return bytes;
}

struct Wire {
  double loss = 0.0;
  double repeat = 0.0;
  bool disorder = false;
  bool cut = false;
};

/// One sender, one receiver, and a wire each way.
class Link {
 public:
  explicit Link(const Wire& wire, SenderLimits limits = {})
      : wire_(wire),
        sender_([this](std::string_view channel, auto bytes) { put(there_, channel, bytes); }, limits),
        receiver_([this](const piece_request_t& request) { put(back_, "PIECE_REQUEST", encode(request)); }) {}

  void publish(const std::string& key, std::int64_t version, const Bytes& object, bool at_once = true) {
    newest_[key] = {version, digest(object)};
    for (const piece_t& piece : cut(object, key, version, version)) {
      sender_.add(kChannel, piece, encode(piece), at_once);
    }
  }

  /// Lets time pass until `until`, with an announcement a second.
  void run(SteadyTime duration) {
    for (const SteadyTime end = now_ + duration; now_ < end; now_ += kTick) {
      sender_.pump(now_);
      if (now_ % kSecond == 0) sender_.announce(now_);
      deliver();
      receiver_.ask(now_);
    }
  }

  /// Whether the newest version of every key has arrived, and is what was sent.
  bool all_there() const {
    for (const auto& [key, newest] : newest_) {
      const auto found = arrived_.find(key);
      if (found == arrived_.end() || found->second != newest) return false;
    }
    return true;
  }

  Wire wire_;
  std::size_t lost_ = 0, delivered_ = 0, largest_ = 0;
  SteadyTime now_ = kSecond;

  ObjectSender sender_;
  ObjectReceiver receiver_;

 private:
  struct Message {
    std::string channel;
    Bytes bytes;
  };

  void put(std::deque<Message>& queue, std::string_view channel, std::span<const std::uint8_t> bytes) {
    largest_ = std::max(largest_, bytes.size());
    if (wire_.cut || random_.uniform() < wire_.loss) {
      ++lost_;
      return;
    }
    const Message message{std::string(channel), {bytes.begin(), bytes.end()}};
    const int copies = random_.uniform() < wire_.repeat ? 2 : 1;
    for (int copy = 0; copy < copies; ++copy) {
      const std::size_t place = wire_.disorder ? random_.below(queue.size() + 1) : queue.size();
      queue.insert(queue.begin() + static_cast<std::ptrdiff_t>(place), message);
    }
  }

  void deliver() {
    for (const Message& message : std::exchange(there_, {})) {
      if (message.channel == "OBJECT_INDEX") {
        receiver_.hear(decode<object_index_t>(message.bytes), now_);
        continue;
      }
      ++delivered_;
      const auto piece = decode<piece_t>(message.bytes);
      receiver_.add(message.channel, piece, now_);
      if (const auto object = assembler_.add(piece)) arrived_[object->key] = {object->version, object->digest};
    }
    for (const Message& message : std::exchange(back_, {})) sender_.answer(decode<piece_request_t>(message.bytes));
  }

  using Name = std::pair<std::int64_t, std::uint64_t>;
  Random random_{7};
  std::deque<Message> there_, back_;
  ObjectAssembler assembler_;
  std::map<std::string, Name> newest_, arrived_;
};

TEST(Delivery, WithoutLossEveryPieceGoesOnceAndNobodyAsks) {
  Random random(1);
  Link link({});
  for (int i = 0; i < 200; ++i) link.publish(std::to_string(i), 1, random_object(random, 100 + random.below(20'000)));
  link.run(10 * kSecond);
  EXPECT_TRUE(link.all_there());
  EXPECT_EQ(link.receiver_.counters().requests, 0U);
  EXPECT_EQ(link.sender_.counters().pieces_resent, 0U);
  EXPECT_EQ(link.delivered_, link.sender_.counters().pieces_sent);
  EXPECT_TRUE(link.receiver_.up_to_date());
  EXPECT_LE(link.largest_, kMaxPieceBytes);
}

TEST(Delivery, KeepsItsRate) {
  Random random(2);
  SenderLimits limits;
  limits.bytes_per_second = 100e3;
  limits.burst_bytes = 5e3;
  Link link({}, limits);
  link.publish("large", 1, random_object(random, 500'000));
  link.run(2 * kSecond);
  const double sent = 1300.0 * static_cast<double>(link.delivered_);
  EXPECT_GT(sent, 180e3);
  EXPECT_LT(sent, 210e3);
  link.run(4 * kSecond);
  EXPECT_TRUE(link.all_there());
}

class LossyWire : public testing::TestWithParam<Wire> {};

TEST_P(LossyWire, EverythingIsThereAWhileAfterTheLastChange) {
  Random random(3);
  Link link(GetParam());
  for (std::int64_t version = 1; version <= 3; ++version) {
    for (int i = 0; i < 60; ++i) {
      const auto size = static_cast<std::size_t>(100 + random.below(30'000));
      link.publish(std::to_string(i), version, random_object(random, size));
    }
    link.run(kSecond);
  }
  link.run(10 * kSecond);
  EXPECT_TRUE(link.all_there());
  EXPECT_TRUE(link.receiver_.up_to_date());
  EXPECT_EQ(link.sender_.waiting(), 0U);
  EXPECT_LE(link.largest_, kMaxPieceBytes);
  if (GetParam().loss > 0) {
    EXPECT_GT(link.receiver_.counters().repaired, 0U);
    EXPECT_GE(link.sender_.counters().pieces_resent, link.receiver_.counters().repaired);
  }
}

INSTANTIATE_TEST_SUITE_P(All, LossyWire,
                         testing::Values(Wire{0.01, 0, false}, Wire{0.05, 0, false}, Wire{0.3, 0, false},
                                         Wire{0, 0.2, true}, Wire{0.1, 0.1, true}));

TEST(Delivery, ALatecomerGetsTheNewestOfEverything) {
  Random random(4);
  Link link({});
  link.wire_.cut = true;
  for (int i = 0; i < 300; ++i) link.publish("tile " + std::to_string(i), 1, random_object(random, 3000));
  link.publish("tile 7", 2, random_object(random, 3000));
  link.run(3 * kSecond);
  link.wire_.cut = false;
  link.run(8 * kSecond);
  EXPECT_TRUE(link.all_there());
}

TEST(Delivery, WhatIsOnlyKeptGoesToThoseWhoAsk) {
  Random random(5);
  Link link({});
  link.publish("kept", 1, random_object(random, 50'000), false);
  link.run(kTick);
  EXPECT_EQ(link.sender_.counters().pieces_sent, 0U);
  link.run(4 * kSecond);
  EXPECT_TRUE(link.all_there());
  EXPECT_EQ(link.sender_.counters().pieces_sent, 0U);
  EXPECT_GT(link.sender_.counters().pieces_resent, 30U);
}

TEST(Delivery, ALinkThatWasCutForLongIsMadeUpForSoon) {
  Random random(6);
  Link link({});
  link.publish("map", 1, random_object(random, 400'000));
  link.run(50'000);  // In the middle of it.
  link.wire_.cut = true;
  link.publish("map 2", 1, random_object(random, 100'000));
  link.run(20 * kSecond);
  EXPECT_FALSE(link.all_there());
  link.wire_.cut = false;
  link.run(5 * kSecond);
  EXPECT_TRUE(link.all_there());
}

TEST(Delivery, WhatNobodyHasAnyMoreIsGivenUpAndCounted) {
  Random random(7);
  Link link({});
  link.publish("gone", 1, random_object(random, 200'000));
  link.run(2 * kTick);
  link.wire_.cut = true;
  link.run(70 * kSecond);
  EXPECT_EQ(link.receiver_.counters().given_up, 1U);
  EXPECT_TRUE(link.receiver_.up_to_date());
  EXPECT_LT(link.receiver_.counters().requests, 60U);  // They become rarer.
}

TEST(Delivery, ARequestNeverExceedsOneFrameNorAsksBeyondTheObject) {
  Random random(8);
  Link link({0.5, 0, true});
  link.publish(std::string(kMaxKeyBytes, 'k'), 1, random_object(random, 600'000));
  link.run(30 * kSecond);
  EXPECT_TRUE(link.all_there());
  EXPECT_LE(link.largest_, kMaxPieceBytes);
}

TEST(Delivery, ForgetsTheOldestObjectsWhenTheyTakeTooMuch) {
  Random random(9);
  SenderLimits limits;
  limits.max_held_bytes = 100'000;
  Link link({}, limits);
  for (int i = 0; i < 20; ++i) link.publish(std::to_string(i), 1, random_object(random, 20'000));
  EXPECT_GE(link.sender_.counters().objects_dropped, 15U);
  link.run(2 * kSecond);
  EXPECT_TRUE(link.all_there());  // They were in the queue.
}

TEST(Delivery, HostileRequestsAskForNothingThatIsNotThere) {
  Random random(10);
  Link link({});
  const Bytes object = random_object(random, 5'000);
  link.publish("object", 1, object);
  link.run(kSecond);
  piece_request_t request{};
  request.channel = kChannel;
  request.key = "object";
  request.version = 1;
  request.digest = static_cast<std::int64_t>(digest(object));
  request.first_piece = {INT32_MIN, -1, 0, INT32_MAX, 3, 5};
  request.end_piece = {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN, 1, INT32_MAX};
  request.nranges = 6;
  link.sender_.answer(request);
  EXPECT_LE(link.sender_.waiting(), cut(object, "object", 1, 1).size());
}

}  // namespace
}  // namespace scanway
