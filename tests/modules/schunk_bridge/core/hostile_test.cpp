// Random, cut, doubled and flipped traffic: nothing crashes, nothing false is believed, good frames are heard again.

#include <gtest/gtest.h>

#include <cmath>

#include "common/random/random.h"
#include "modules/schunk_bridge/core/candump.h"
#include "modules/schunk_bridge/core/listener.h"
#include "modules/schunk_bridge/core/request.h"
#include "tests/modules/schunk_bridge/core/bench_of_two.h"

namespace scanway {
namespace {

#ifndef SCANWAY_RANDOM_STREAMS
#define SCANWAY_RANDOM_STREAMS 20000
#endif

CanFrame random_frame(Random& random) {
  static constexpr std::uint8_t starts[] = {0x80, 0x81, 0x84, 0x84, 0x85, 0x86, 0x86,
                                            0x88, 0x8A, 0x93, 0x94, 0x95, 0xB0};
  CanFrame frame;
  static constexpr std::uint16_t ids[] = {0x300, 0x500, 0x700, 0x700, 0x700};
  frame.id = static_cast<std::uint16_t>(ids[random.below(5)] + 11 + random.below(2));
  if (random.below(20) == 0) frame.id = static_cast<std::uint16_t>(random.below(0x800));
  frame.size = static_cast<std::uint8_t>(random.below(9));
  for (auto& byte : frame.data) byte = static_cast<std::uint8_t>(random.next());
  frame.data[0] = static_cast<std::uint8_t>(random.below(random.below(4) == 0 ? 256 : 18));
  if (random.below(4) != 0) frame.data[1] = starts[random.below(std::size(starts))];
  return frame;
}

TEST(HostileTraffic, RandomStreamsAreRead) {
  Random random(1);
  std::size_t readings = 0, bad = 0;
  for (int stream = 0; stream < SCANWAY_RANDOM_STREAMS; ++stream) {
    schunk::Listener listener;
    const std::size_t count = 1 + random.below(40);
    std::vector<int> told(count, 0);
    const auto tell = [&](const std::vector<schunk::BadFrames>& stretches) {
      for (const auto& stretch : stretches) {
        for (const std::size_t frame : stretch.frames) ++told[frame];
      }
      bad += stretches.size();
    };
    for (std::size_t i = 0; i < count; ++i) {
      const auto result = listener.add(random_frame(random), i, static_cast<Utime>(i) * 1000);
      tell(result.bad);
      for (const auto& reading : result.readings) {
        for (const std::size_t frame : reading.frames) ++told[frame];
      }
      readings += result.readings.size();
    }
    tell(listener.end());
    for (const int times : told) ASSERT_EQ(times, 1) << "stream " << stream;  // Each frame is accounted for, once.
  }
  EXPECT_GT(readings, 1000u);
  EXPECT_GT(bad, 1000u);
}

TEST(HostileTraffic, RandomStreamsDoNotMoveAnything) {
  Random random(2);
  for (int stream = 0; stream < SCANWAY_RANDOM_STREAMS / 10; ++stream) {
    test::BenchOfTwo bench;
    for (int i = 0; i < 60; ++i) {
      bench.bridge.receive(random_frame(random), bench.now);
      bench.step();
      bench.now += 1000;
    }
    ASSERT_TRUE(bench.pan.move_targets.empty() && bench.tilt.move_targets.empty());
    for (const auto* axis : {&bench.bridge.pan(), &bench.bridge.tilt()}) {
      if (axis->state()) {
        ASSERT_TRUE(std::isfinite(axis->state()->position));
      }
    }
  }
}

TEST(HostileTraffic, RandomLinesAreParsed) {
  Random random(3);
  const std::string alphabet = "0123456789ABCDEFabcdef#.()[] RTXcan\t\r\0\xFF";
  for (int i = 0; i < SCANWAY_RANDOM_STREAMS; ++i) {
    std::string line =
        random.below(2) ? "(1436509052.249713) can0 70B#05B600002041" : " can0  70B   [6]  05 B6 00 00 20 41";
    for (std::uint64_t edits = random.below(6); edits > 0; --edits) {
      const std::size_t at = random.below(line.size() + 1);
      if (random.below(2) && at < line.size()) {
        line.erase(at, 1 + random.below(4));
      } else {
        line.insert(at, 1, alphabet[random.below(alphabet.size())]);
      }
    }
    const auto parsed = schunk::parse_can_line(line);
    if (parsed) {
      ASSERT_LE(parsed->frame.size, 8);
    }
    if (parsed && parsed->kind == schunk::CanLine::Kind::data) {
      ASSERT_LE(parsed->id, 0x7FFu);
    }
  }
}

/// The frames of ten states with position and velocity of module 11; state k is at 10 k.
std::vector<CanFrame> ten_states() {
  std::vector<CanFrame> frames;
  for (int k = 0; k < 10; ++k) {
    schunk::Message message;
    message.direction = schunk::Direction::from_module;
    message.module = 11;
    message.command = schunk::Command::get_state;
    schunk::append_float(message.parameters, static_cast<float>(10 * k));
    schunk::append_float(message.parameters, static_cast<float>(k));
    message.parameters.push_back(0x03);
    message.parameters.push_back(0);
    for (const CanFrame& frame : to_frames(message)) frames.push_back(frame);
  }
  return frames;
}

/// The states that are read out of frames.
std::vector<std::pair<double, double>> states_in(const std::vector<CanFrame>& frames) {
  schunk::MessageAssembler assembler;
  std::vector<std::pair<double, double>> states;
  for (const CanFrame& frame : frames) {
    const auto result = assembler.add(frame, 0, 0);
    if (!result.message) continue;
    const auto reply = parse_reply(*result.message, 3, schunk::UnitSystem::degree);
    if (const auto* state = std::get_if<schunk::reply::State>(&reply))
      states.push_back({*state->position, *state->velocity});
  }
  return states;
}

TEST(HostileTraffic, LostAndDoubledFramesCostAtMostTheirNeighbours) {
  const std::vector<CanFrame> whole = ten_states();
  ASSERT_EQ(whole.size(), 20u);
  ASSERT_EQ(states_in(whole).size(), 10u);
  for (const bool doubled : {false, true}) {
    for (std::size_t at = 0; at < whole.size(); ++at) {
      std::vector<CanFrame> frames = whole;
      if (doubled) {
        frames.insert(frames.begin() + static_cast<long>(at), whole[at]);
      } else {
        frames.erase(frames.begin() + static_cast<long>(at));
      }
      const auto states = states_in(frames);
      EXPECT_GE(states.size(), 9u);
      for (const auto& [position, velocity] : states) EXPECT_EQ(position, 10 * velocity);  // Never of two messages.
      if (at < 16) {
        EXPECT_EQ(states.back().first, 90);
      }
    }
  }
}

TEST(HostileTraffic, MessagesOfEveryLengthComeBack) {
  Random random(4);
  for (std::size_t length = 0; length <= 254; ++length) {
    schunk::Message message;
    message.direction = schunk::Direction::from_module;
    message.module = 200;
    message.command = schunk::Command::get_config;
    for (std::size_t i = 0; i < length; ++i) message.parameters.push_back(static_cast<std::uint8_t>(random.next()));
    schunk::MessageAssembler assembler;
    std::optional<schunk::Message> back;
    const auto frames = to_frames(message);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const auto result = assembler.add(frames[i], i, 0);
      ASSERT_TRUE(result.bad.empty()) << length;
      ASSERT_EQ(result.message.has_value(), i + 1 == frames.size()) << length;
      back = result.message;
    }
    EXPECT_EQ(*back, message) << length;
  }
}

TEST(Units, ComeBackFromTheWire) {
  Random random(5);
  for (const auto units : {schunk::UnitSystem::radian, schunk::UnitSystem::degree, schunk::UnitSystem::microdegree_int,
                           schunk::UnitSystem::millidegree_int}) {
    for (int i = 0; i < 1000; ++i) {
      const double value = (random.uniform() - 0.5) * 2e6;
      std::vector<std::uint8_t> bytes;
      schunk::append_number(bytes, value, units);
      ASSERT_EQ(bytes.size(), 4u);
      EXPECT_NEAR(schunk::read_number(bytes, units), value, schunk::is_integer(units) ? 0.5 : 0.07);
    }
    std::vector<std::uint8_t> bytes;
    schunk::append_number(bytes, 1e300, units);
    schunk::append_number(bytes, -1e300, units);
    schunk::append_number(bytes, std::nan(""), units);
    EXPECT_EQ(bytes.size(), 12u);
  }
}

}  // namespace
}  // namespace scanway
