#include "modules/base_bridge/core/packet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>

#include <nlohmann/json.hpp>

#include "common/random/random.h"
#include "modules/base_bridge/core/command.h"
#include "modules/base_bridge/core/odometry.h"
#include "modules/base_bridge/core/report.h"
#include "tests/modules/base_bridge/test_robot.h"
#include "tests/support/command.h"

namespace scanway {
namespace {

using erratic::Command;
using Json = nlohmann::json;
using ByteVector = std::vector<std::uint8_t>;

#ifndef SCANWAY_RANDOM_STREAMS
#define SCANWAY_RANDOM_STREAMS 20000
#endif

ByteVector bytes_of(const std::string& hex) {
  ByteVector bytes;
  std::istringstream in(hex);
  for (std::string word; in >> word;) bytes.push_back(static_cast<std::uint8_t>(std::stoi(word, nullptr, 16)));
  return bytes;
}

Json vectors() {
  const std::string path = SCANWAY_SHARED_DIR "/facts/erratic/vectors.json";
  return std::filesystem::exists(path) ? Json::parse(test::read_text(path)) : Json();
}

TEST(Packets, AreTheSheets) {
  const Json sheet = vectors();
  if (sheet.is_null()) GTEST_SKIP() << "the shared facts are not here";
  const std::map<std::string, erratic::Packet> made = {
      {"configuration_request", erratic::make_command(Command::configuration)},
      {"open_controller", erratic::make_command(Command::open_controller)},
      {"pulse", erratic::make_command(Command::pulse)},
      {"close_controller", erratic::make_command(Command::close_controller)},
      {"stop", erratic::make_command(Command::stop)},
      {"enable_motors_1", erratic::make_command(Command::enable_motors, 1)},
      {"enable_motors_0", erratic::make_command(Command::enable_motors, 0)},
      {"trans_vel_200", erratic::make_command(Command::trans_vel, 200)},
      {"trans_vel_m200", erratic::make_command(Command::trans_vel, -200)},
      {"trans_vel_0", erratic::make_command(Command::trans_vel, 0)},
      {"rot_vel_30", erratic::make_command(Command::rot_vel, 30)},
      {"rot_vel_m30", erratic::make_command(Command::rot_vel, -30)},
      {"rot_pos_90", erratic::make_command(Command::rot_pos, 90)},
      {"rot_dpos_m45", erratic::make_command(Command::rot_dpos, -45)},
      {"max_trans_acc_500", erratic::make_command(Command::set_max_trans_acc, 500)},
      {"max_trans_acc_as_decel_m500", erratic::make_command(Command::set_max_trans_acc, -500)},
      {"max_rot_acc_100", erratic::make_command(Command::set_max_rot_acc, 100)},
      {"max_rot_acc_as_decel_m100", erratic::make_command(Command::set_max_rot_acc, -100)},
      {"sonar_1", erratic::make_command(Command::set_sonar, 1)},
      {"analog_1", erratic::make_command(Command::set_analog, 1)},
      {"pwm_freq_16000", erratic::make_command(Command::set_pwm_freq, 16000)},
      {"pwm_max_on_700", erratic::make_command(Command::set_pwm_max_on, 700)},
      {"pid_trans_p_40", erratic::make_command(Command::trans_pid_p, 40)},
      {"pid_trans_v_100", erratic::make_command(Command::trans_pid_v, 100)},
      {"pid_rot_p_40", erratic::make_command(Command::rot_pid_p, 40)},
      {"pid_rot_v_100", erratic::make_command(Command::rot_pid_v, 100)},
      {"save_config", erratic::make_save_config()},
      {"wheel_vel_left200_right100", erratic::make_wheel_velocities(200, 100)},
      {"wheel_vel_left_m200_right200", erratic::make_wheel_velocities(-200, 200)},
      {"servo_2_position_1650", erratic::make_servo_position(2, 1650)},
  };
  std::size_t compared = 0;
  for (const Json& vector : sheet["vectors"]) {
    if (vector["direction"] != "host to robot") continue;
    ASSERT_TRUE(made.contains(vector["name"])) << vector["name"];
    EXPECT_EQ(made.at(vector["name"]), bytes_of(vector["hex"])) << vector["name"];
    ++compared;
  }
  EXPECT_EQ(compared, made.size());
}

TEST(Odometry, FollowsTheSheetsSequence) {
  const Json sheet = vectors();
  if (sheet.is_null()) GTEST_SKIP() << "the shared facts are not here";
  for (const auto& [revision, scale] : {std::pair{"E", 0.780e-3}, std::pair{"H", 0.930e-3}}) {
    erratic::Odometry odometry(scale);
    Utime now = 1'000'000;
    int dropped = 0;
    for (const Json& step : sheet["odometry_sequence"]["steps"]) {
      const ByteVector packet = bytes_of(step["hex"]);
      const auto report = erratic::read_report(erratic::payload_of(packet));
      dropped +=
          odometry.add(std::get<erratic::MotorReport>(report), now += 50'000) == erratic::Odometry::Step::dropped;
      EXPECT_NEAR(odometry.pose().x_m * 1000, step["unrounded_xy_mm"][revision][0].get<double>(), 1e-9);
      EXPECT_NEAR(odometry.pose().y_m * 1000, step["unrounded_xy_mm"][revision][1].get<double>(), 1e-9);
    }
    EXPECT_EQ(dropped, 1);
  }
}

TEST(Odometry, ReducesTheHeadingToOneTurn) {
  erratic::Odometry odometry;
  erratic::MotorReport report;
  Utime now = 0;
  for (const int counts : {0, 1024, 2048, 3072, 4095, -1024, -2048, 32767, -32768}) {
    report.heading_counts = static_cast<std::int16_t>(counts);
    odometry.add(report, now += 50'000);
    EXPECT_NEAR(std::cos(odometry.pose().heading), std::cos(counts * M_PI / 2048), 1e-9) << counts;
    EXPECT_NEAR(std::sin(odometry.pose().heading), std::sin(counts * M_PI / 2048), 1e-9) << counts;
    EXPECT_LE(std::fabs(odometry.pose().heading), M_PI);
  }
}

TEST(Odometry, SaysThatAGapIsOne) {
  erratic::Odometry odometry(1e-3);
  erratic::MotorReport report;
  report.heading_counts = 100;
  EXPECT_EQ(odometry.add(report, 0), erratic::Odometry::Step::first);
  report.x_counts = 90;
  EXPECT_EQ(odometry.add(report, 50'000), erratic::Odometry::Step::added);
  report.x_counts = 500;  // 0.41 m in 0.5 s is no jump.
  EXPECT_EQ(odometry.add(report, 550'000), erratic::Odometry::Step::added);
  EXPECT_NEAR(odometry.pose().x_m, 0.5, 1e-9);
  report.x_counts = 1500;
  EXPECT_EQ(odometry.add(report, 2'550'000), erratic::Odometry::Step::continued);
  EXPECT_NEAR(odometry.pose().x_m, 0.5, 1e-9);
}

/// The whole packets of a stream that comes in random pieces.
std::vector<ByteVector> packets_in(const ByteVector& stream, Random& random) {
  FrameFinder finder = erratic::make_packet_finder();
  std::vector<ByteVector> packets;
  std::uint64_t covered = 0;
  const auto take = [&] {
    while (const auto stretch = finder.next()) {
      EXPECT_EQ(stretch->offset, covered);
      covered += stretch->length;
      if (stretch->whole) packets.push_back(stretch->bytes);
    }
  };
  for (std::size_t at = 0; at < stream.size();) {
    const std::size_t count = std::min<std::size_t>(1 + random.below(40), stream.size() - at);
    finder.push(std::span(stream).subspan(at, count));
    at += count;
    take();
  }
  finder.finish();
  take();
  EXPECT_EQ(covered, stream.size());
  return packets;
}

TEST(HostileStreams, GiveNothingFromABadChecksum) {
  Random random(1);
  std::size_t found = 0;
  for (int i = 0; i < SCANWAY_RANDOM_STREAMS; ++i) {
    ByteVector stream;
    for (std::uint64_t k = random.below(12); k > 0; --k) {
      ByteVector payload(1 + random.below(24));
      for (auto& byte : payload)
        byte = static_cast<std::uint8_t>(random.below(3) ? random.next() : 0xFA + random.below(2));
      static constexpr std::uint8_t types[] = {0x80, 0x82, 0x83, 0x20, 0x9A, 0x9B, 0x15, 0x90, 0x20, 0x0B};
      payload[0] = types[random.below(std::size(types))];
      const ByteVector packet = test::TestRobot::packet(payload);
      stream.insert(stream.end(), packet.begin(), packet.end());
    }
    for (std::uint64_t edits = random.below(5); edits > 0 && !stream.empty(); --edits) {
      const auto at = static_cast<long>(random.below(stream.size()));
      switch (random.below(3)) {
        case 0:
          stream.erase(stream.begin() + at);
          break;
        case 1:
          stream.insert(stream.begin() + at, stream[static_cast<std::size_t>(at)]);
          break;
        default:
          stream[static_cast<std::size_t>(at)] ^= static_cast<std::uint8_t>(1 << random.below(8));
          break;
      }
    }
    for (const ByteVector& packet : packets_in(stream, random)) {
      const ByteVector payload(packet.begin() + 3, packet.end() - 2);
      ASSERT_EQ(packet, test::TestRobot::packet(payload));
      const auto report = erratic::read_report(payload);
      (void)erratic::read_command(payload);
      if (const auto* motors = std::get_if<erratic::MotorReport>(&report)) {
        ASSERT_TRUE(motors->x_counts < 4096 && motors->y_counts < 4096);
      }
      ++found;
    }
  }
  EXPECT_GT(found, 1000u);
}

TEST(HostileStreams, AreHeardAgainWithinTwoPackets) {
  Random random(2);
  const ByteVector good = test::TestRobot::packet({0x83, 100, 0, 0, 0, 0, 0, 0, 0, 0xA6, 0, 0xA6, 0, 0x7A, 0, 0, 0, 0});
  for (int i = 0; i < SCANWAY_RANDOM_STREAMS / 10; ++i) {
    FrameFinder finder = erratic::make_packet_finder();
    ByteVector noise(random.below(100));
    for (auto& byte : noise) byte = static_cast<std::uint8_t>(random.below(3) ? random.next() : 0xFA + random.below(2));
    finder.push(noise);
    while (finder.next()) {
    }
    int after = 0;
    for (bool heard = false; !heard; ++after) {
      ASSERT_LT(after, 2) << "stream " << i;
      finder.push(good);
      while (const auto stretch = finder.next()) heard = heard || stretch->bytes == good;
    }
  }
}

}  // namespace
}  // namespace scanway
