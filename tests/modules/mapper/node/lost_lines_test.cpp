// Lines that were lost, asked for again, and given up.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "common/random/random.h"
#include "modules/sick_bridge/node/line_archive.h"
#include "tests/modules/mapper/node/raw_sweep.h"

namespace scanway::test {
namespace {

/// The bridge's end: keeps each line, and loses `loss` of what it sends, in pieces.
class LossyBridge {
 public:
  LossyBridge(Assembler& to, double loss) : to_(to), loss_(loss) {}

  /// `last`: no more pieces of that line will come.
  void say(const Said& said, bool last) {
    if (random_.uniform() >= loss_) to_.feed(said);
    line_.push_back(said.bytes);
    if (last) archive_.keep(std::exchange(line_, {}), said.utime);
  }
  void answer(Utime now, std::int64_t first_line) {
    for (; answered_ < to_.requests.size(); ++answered_) {
      const line_request_t& request = to_.requests[answered_];
      for (std::size_t i = 0; i < request.first_line.size(); ++i) {
        archive_.ask(request.first_line[i] - first_line, request.end_line[i] - first_line, now);
      }
    }
    archive_.pump(now, [&](const auto& message) {
      if (random_.uniform() >= loss_) to_.feed({std::string(channel::kLaserLine.name), message, now});
    });
  }
  const sick::LineArchive& archive() const { return archive_; }

 private:
  Assembler& to_;
  double loss_;
  Random random_{1};
  sick::LineArchive archive_;
  std::vector<sick::LineArchive::Message> line_;
  std::size_t answered_ = 0;
};

TEST(SweepAssembler, LinesThatWereLostAreAskedForUntilAllAreThere) {
  Assembler lossless, lossy;
  lossless.feed(raw_log()).finish();
  LossyBridge bridge(lossy, 0.3);
  const std::int64_t first = line_of(*std::find_if(raw_log().begin(), raw_log().end(), is_line));
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < raw_log().size(); ++i) {
    if (is_line(raw_log()[i])) lines.push_back(i);
  }
  for (std::size_t i = 0, line = 0; i < raw_log().size(); ++i) {
    const Said& said = raw_log()[i];
    if (!is_line(said)) {
      lossy.feed(said);
    } else {
      ++line;
      bridge.say(said, line == lines.size() || line_of(raw_log()[lines[line]]) != line_of(said));
    }
    bridge.answer(said.utime, first);
  }
  // The tracker goes on.
  Said imu =
      *std::find_if(raw_log().rbegin(), raw_log().rend(), [](const Said& said) { return said.channel == "IMU"; });
  for (int i = 0; i < 3000 && lossy.sweeps.empty(); ++i) {
    auto message = decode<bot_core::ins_t>(imu.bytes);
    message.utime += 10'000;
    imu = {imu.channel, encode(message), imu.utime + 10'000};
    lossy.feed(imu);
    bridge.answer(imu.utime, first);
  }
  ASSERT_EQ(lossy.sweeps.size(), 1U);
  EXPECT_EQ(lossy.sweeps[0].bytes, lossless.sweeps[0].bytes);
  EXPECT_EQ(used(lossy.origins[0]), used(lossless.origins[0]));
  EXPECT_GT(bridge.archive().counters().lines_resent, 50);
  EXPECT_EQ(lossy.node.counters().at("assembler_missing_lines"), 0);
  EXPECT_LT(lossy.node.counters().at("assembler_lines_asked"), 3 * bridge.archive().counters().lines_resent);
}

TEST(SweepAssembler, LinesThatNeverComeAreCountedAfterABound) {
  Log log;
  for (const Said& said : raw_log()) {
    if (!is_line(said) || line_of(said) < 120 || line_of(said) > 124) log.push_back(said);
  }
  Assembler assembler;
  assembler.feed(log);
  EXPECT_TRUE(assembler.sweeps.empty()) << "they may still come";
  EXPECT_TRUE(assembler.node.busy());
  EXPECT_NE(assembler.node.summary().find("waits for its data"), std::string::npos);
  Said imu = *std::find_if(log.rbegin(), log.rend(), [](const Said& said) { return said.channel == "IMU"; });
  auto message = decode<bot_core::ins_t>(imu.bytes);
  message.utime += 41 * kMicrosecondsPerSecond;
  assembler.feed({imu.channel, encode(message), 0});
  ASSERT_EQ(assembler.sweeps.size(), 1U);
  EXPECT_EQ(assembler.sweeps[0].bytes, encode(expected(log).sweep));
  EXPECT_EQ(assembler.node.counters().at("assembler_missing_lines"), 5);
  EXPECT_LE(assembler.node.counters().at("assembler_lines_asked"), 5 * 10) << "asked for with a cap";
  EXPECT_EQ(assembler.node.summary(), "sweep_7: lacks 5 lines");
  ASSERT_FALSE(assembler.requests.empty());
  EXPECT_EQ(assembler.requests[0].first_line[0], 120);

  Said late =
      *std::find_if(raw_log().begin(), raw_log().end(), [](const Said& s) { return is_line(s) && line_of(s) == 121; });
  assembler.feed(late);
  EXPECT_EQ(assembler.node.counters().at("assembler_late_lines"), 1);
  EXPECT_EQ(assembler.sweeps.size(), 1U);
}

TEST(SweepAssembler, InSilenceItAsksAFewTimesAndThenTakesWhatIsThere) {
  Log log;
  for (const Said& said : raw_log()) {
    if (!is_line(said) || line_of(said) != 348) log.push_back(said);
  }
  Assembler assembler;
  assembler.feed(log);
  const std::size_t before = assembler.requests.size();
  for (int i = 0; i < 10 && assembler.sweeps.empty(); ++i) {
    assembler.node.settle();
    assembler.bus.dispatch();
  }
  EXPECT_EQ(assembler.sweeps.size(), 1U);
  EXPECT_GE(assembler.requests.size(), before + 2);
  EXPECT_FALSE(assembler.node.busy());
}

/// Each line in two pieces, and all lines after all that the other channels say.
Log in_pieces_after_the_rest(const Log& log) {
  Log rest, lines;
  for (const Said& said : log) {
    if (!is_line(said)) {
      rest.push_back(said);
      continue;
    }
    const auto whole = decode<laser_line_t>(said.bytes);
    const auto half = static_cast<std::ptrdiff_t>(whole.nbeams / 2);
    laser_line_t left = whole, right = whole;
    left.range_count.resize(static_cast<std::size_t>(half));
    left.rssi_count.resize(static_cast<std::size_t>(half));
    right.range_count.erase(right.range_count.begin(), right.range_count.begin() + half);
    right.rssi_count.erase(right.rssi_count.begin(), right.rssi_count.begin() + half);
    right.first_beam = static_cast<std::int32_t>(half);
    for (laser_line_t* piece : {&left, &right}) {
      piece->nbeams = piece->nrssi = static_cast<std::int32_t>(piece->range_count.size());
      lines.push_back({said.channel, encode(*piece), said.utime});
    }
  }
  rest.insert(rest.end(), lines.begin(), lines.end());
  return rest;
}

TEST(LostLines, ASweepIsNotMadeBeforeTheLastPieceOfItsLastLine) {
  const Log log = in_pieces_after_the_rest(raw_log());
  Assembler assembler;
  assembler.feed(log).finish();
  ASSERT_EQ(assembler.sweeps.size(), 1U);
  EXPECT_EQ(assembler.sweeps[0].bytes, encode(expected(raw_log()).sweep));
  EXPECT_EQ(assembler.node.counters().at("assembler_missing_beams"), 0);
  EXPECT_EQ(assembler.node.counters().at("assembler_late_lines"), 0);
}

}  // namespace
}  // namespace scanway::test
