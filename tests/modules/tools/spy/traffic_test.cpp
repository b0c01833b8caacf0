#include "modules/tools/spy/traffic.h"

#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "bot_core/ins_t.hpp"
#include "common/bus/channels.h"
#include "common/messages/codec.h"
#include "common/messages/objects.h"
#include "common/random/random.h"
#include "modules/tools/spy/message_json.h"
#include "modules/tools/spy/traffic_text.h"
#include "scanway/goal_t.hpp"
#include "scanway/laser_line_t.hpp"
#include "scanway/path_t.hpp"
#include "tests/common/messages/random_wire.h"
#include "tests/live/hostile/messages/hostile_messages.h"

namespace scanway::tools {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr SteadyTime kSecond = 1'000'000;

Bytes imu(std::int64_t utime) {
  bot_core::ins_t message{};
  message.utime = utime;
  return encode(message);
}
Bytes line(std::int64_t number) {
  laser_line_t message{};
  message.line = number;
  return encode(message);
}
Bytes path(int nposes) {
  path_t message{};
  message.mode = "footprint";
  message.nposes = nposes;
  for (int i = 0; i < nposes; ++i) {
    message.pose_x_m.push_back(std::sqrt(i));
    message.pose_y_m.push_back(std::sqrt(i + 1));
    message.pose_heading_rad.push_back(0);
    message.pose_time_s.push_back(i);
    message.pose_speed_m_s.push_back(0.25);
  }
  return encode(message);
}

TEST(Traffic, RateJitterAndBytesAreThoseOfTheMessages) {
  Traffic traffic(5 * kSecond);
  const Bytes message = imu(1);
  SteadyTime now = 0;
  for (int i = 0; i <= 1000; ++i) {  // 100 Hz, every other one 2 ms late.
    now = i * 10'000;
    traffic.take({"IMU", message}, now + (i % 2) * 2'000);
  }
  const Arrivals& arrivals = traffic.channels().at("IMU").arrivals;
  EXPECT_NEAR(arrivals.rate_hz(now), 100.0, 0.1);
  EXPECT_NEAR(*arrivals.jitter_s(), 0.002, 1e-5);
  EXPECT_NEAR(arrivals.bytes_per_s(now), 100.0 * static_cast<double>(message.size()), 20.0);
  EXPECT_EQ(arrivals.rate_hz(now + 10 * kSecond), 0.0);
  EXPECT_NEAR(arrivals.age_s(now + 10 * kSecond), 10.0, 0.01);
  EXPECT_EQ(traffic.channels().at("IMU").bytes, 1001 * message.size());
}

TEST(Traffic, ASlowChannelHasARateToo) {
  Traffic traffic(5 * kSecond);
  for (int i = 0; i < 4; ++i) traffic.take({"IMU", imu(i)}, i * 20 * kSecond);
  EXPECT_NEAR(traffic.channels().at("IMU").arrivals.rate_hz(60 * kSecond), 0.05, 1e-9);
}

TEST(Gaps, OfNumberedMessages) {
  Traffic traffic(5 * kSecond);
  const auto missing = [&] { return *traffic.channels().at("LASER_LINE").gaps.missing(); };
  for (const int number : {5, 5, 6, 7, 7, 10, 8, 11}) traffic.take({"LASER_LINE", line(number)}, 0);
  EXPECT_EQ(missing(), 2U);  // 8 and 9; that 8 came late does not mend the bus.
  traffic.take({"LASER_LINE", line(0)}, 0);
  traffic.take({"LASER_LINE", line(1)}, 0);
  EXPECT_EQ(missing(), 2U);  // The device was switched on again.
  traffic.take({"LASER_LINE", line(INT64_MAX)}, 0);
  traffic.take({"LASER_LINE", line(INT64_MIN)}, 0);
  EXPECT_EQ(missing(), 2U);
}

TEST(Gaps, OfEvenlySpacedMessages) {
  Random random(3);
  Traffic traffic(5 * kSecond);
  std::uint64_t left_out = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto utime = 10'000 * i + static_cast<std::int64_t>(random.below(1500));
    if (i > 20 && random.below(20) == 0) {
      ++left_out;
    } else {
      traffic.take({"IMU", imu(utime)}, 0);
    }
  }
  traffic.take({"IMU", imu(10'000 * 2000)}, 0);
  EXPECT_GT(left_out, 50U);
  EXPECT_EQ(traffic.channels().at("IMU").gaps.missing(), left_out);
}

TEST(Gaps, AreNotGuessed) {
  Random random(4);
  Traffic traffic(5 * kSecond);
  std::int64_t utime = 0;
  for (int i = 0; i < 500; ++i) {
    utime += 1 + static_cast<std::int64_t>(random.below(1'000'000));
    traffic.take({"IMU", imu(utime)}, 0);
  }
  EXPECT_EQ(traffic.channels().at("IMU").gaps.missing(), std::nullopt);
}

TEST(Traffic, PutsObjectsTogether) {
  std::vector<Sighting::Kind> kinds;
  Bytes object;
  Traffic traffic(5 * kSecond, [&](const Sighting& sighting) {
    kinds.push_back(sighting.kind);
    if (sighting.kind != Sighting::Kind::object) return;
    EXPECT_EQ(sighting.channel, "PATH");
    EXPECT_EQ(sighting.piece->key, "footprint");
    object.assign(sighting.bytes.begin(), sighting.bytes.end());
  });
  const Bytes whole = path(500);
  const auto pieces = cut(whole, "footprint", 1, 0);
  ASSERT_GT(pieces.size(), 2U);
  for (std::size_t i = 1; i < pieces.size(); ++i) traffic.take({"PATH", encode(pieces[i])}, 0);
  EXPECT_NE(traffic_table(traffic, 0).find("0 objects, 1 incomplete (1 pieces missing)"), std::string::npos);
  traffic.take({"PATH", encode(pieces[0])}, 0);
  EXPECT_EQ(object, whole);
  std::vector<Sighting::Kind> expected(pieces.size(), Sighting::Kind::piece);
  expected.push_back(Sighting::Kind::object);
  EXPECT_EQ(kinds, expected);
  EXPECT_EQ(traffic.channels().at("PATH").type, "scanway.path_t");
  EXPECT_EQ(traffic.channels().at("PATH").objects, 1U);
}

TEST(Traffic, NamesWhatIsBad) {
  Traffic traffic(5 * kSecond);
  const auto fault = [&](const std::string& channel) { return traffic.channels().at(channel).last_fault; };
  Bytes goal = encode(goal_t{});
  goal.pop_back();
  traffic.take({"GOAL", goal}, 0);
  EXPECT_EQ(fault("GOAL"), "scanway.goal_t.goal_y_m: cut off");
  traffic.take({"GOAL", imu(1)}, 0);
  EXPECT_EQ(fault("GOAL"), "not scanway.goal_t but bot_core.ins_t");
  traffic.take({"IMU", {}}, 0);
  EXPECT_EQ(fault("IMU"), "too short to have a type");
  auto pieces = cut(path(500), "footprint", 1, 0);
  pieces[1].data[3] ^= 1;
  for (const piece_t& piece : pieces) traffic.take({"PATH", encode(piece)}, 0);
  EXPECT_EQ(fault("PATH"), "object 'footprint' is not what its digest says");
  for (const piece_t& piece : cut(imu(1), "imu", 1, 0)) traffic.take({"PATH", encode(piece)}, 0);
  EXPECT_EQ(fault("PATH"), "object 'imu': not scanway.path_t but bot_core.ins_t");
  EXPECT_NE(traffic_table(traffic, 0).find("bad on GOAL: not scanway.goal_t but bot_core.ins_t\n"), std::string::npos);
}

TEST(Traffic, KnowsChannelsThatAreNotOurs) {
  std::size_t foreign = 0;
  Traffic traffic(5 * kSecond,
                  [&](const Sighting& sighting) { foreign += sighting.kind == Sighting::Kind::foreign ? 1 : 0; });
  traffic.take({"CAMERA\n", Bytes(16, 0xAB)}, 0);
  traffic.take({"SECOND_TRACKER", imu(1)}, 0);  // A type of ours on a channel of theirs.
  EXPECT_EQ(foreign, 1U);
  EXPECT_EQ(traffic.channels().at("CAMERA\n").type, "abababababababab");
  EXPECT_EQ(traffic.channels().at("SECOND_TRACKER").type, "bot_core.ins_t");
  EXPECT_NE(traffic_table(traffic, 0).find("CAMERA\\n "), std::string::npos);
}

TEST(Traffic, OutlivesLies) {
  std::uint64_t told = 0, bad = 0, shown = 0;
  Traffic traffic(5 * kSecond, [&](const Sighting& sighting) {
    bad += sighting.kind == Sighting::Kind::bad ? 1 : 0;
    EXPECT_EQ(sighting.kind == Sighting::Kind::bad, !sighting.reason.empty());
    if (sighting.kind != Sighting::Kind::message && sighting.kind != Sighting::Kind::object) return;
    ++shown;
    EXPECT_FALSE(message_text(message_json(*sighting.layout, sighting.bytes, 3)).empty());
  });
  Random random(8);
  const auto take = [&](const Channel& channel, const Bytes& bytes) {
    ++told;
    traffic.take({channel.name, bytes}, 0);
  };
  for (const Channel& channel : kChannels) {
    const Layout& layout = *find_layout(channel.cut ? std::string_view("scanway.piece_t") : channel.type);
    test::tell_lies(layout, random, 50, [&](const Bytes& bytes) { take(channel, bytes); });
    if (!channel.cut) continue;
    const auto take_piece = [&](const piece_t& piece) { take(channel, encode(piece)); };
    test::tell_lying_objects(channel, random, 100, take_piece);
    test::tell_contradictions(random, 1, take_piece);
  }
  std::printf("%lu messages: %lu bad, %lu shown\n", told, bad, shown);
  EXPECT_GT(bad, 1000U);
  EXPECT_FALSE(traffic_json(traffic, 0).dump().empty());
}

TEST(Traffic, OutlivesNoiseOnManyChannels) {
  Random random(9);
  Traffic traffic(5 * kSecond);
  for (int i = 0; i < 3000; ++i) {
    const Layout& layout = layouts()[random.below(layouts().size())];
    Bytes wire = test::random_wire(layout, random, 6);
    wire[random.below(wire.size())] ^= static_cast<std::uint8_t>(1U << random.below(8));
    std::string channel = std::to_string(random.below(3000));
    traffic.take({channel.insert(0, 1, 'X'), wire}, i);
  }
  EXPECT_EQ(traffic.channels().size(), Traffic::kMostChannels);
  EXPECT_GT(traffic.ignored(), 0U);
}

}  // namespace
}  // namespace scanway::tools
