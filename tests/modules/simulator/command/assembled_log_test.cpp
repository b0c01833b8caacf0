#include <gtest/gtest.h>

#include "common/bus/channels.h"
#include "common/bus/log_reader.h"
#include "common/cloud/read_cloud.h"
#include "common/messages/codec.h"
#include "common/messages/imu_message.h"
#include "modules/mapper/core/assembly/assembly.h"
#include "modules/mapper/core/assembly/line_collector.h"
#include "modules/simulator/core/simulator.h"
#include "modules/simulator/node/raw_messages.h"
#include "tests/end_to_end/scanway.h"

namespace scanway::simulator {
namespace {

using scanway::test::ScratchFolder;

LinePiece piece_of(const laser_line_t& message) {
  LinePiece piece;
  piece.line.number = message.line;
  piece.line.utime = message.utime;
  piece.line.beam_period_us = message.beam_period_us;
  piece.line.start_angle_rad = message.start_angle_rad;
  piece.line.angle_step_rad = message.angle_step_rad;
  piece.line.range_scale_m = message.range_scale_m;
  piece.line.rssi_scale = message.rssi_scale;
  piece.line.range_counts.assign(message.range_count.begin(), message.range_count.end());
  piece.line.rssi_counts.assign(message.rssi_count.begin(), message.rssi_count.end());
  piece.numbered_since = message.numbered_since;
  piece.beams_of_line = message.nbeams_of_line;
  piece.first_beam = message.first_beam;
  return piece;
}

/// All of a log of one sweep that an assembler needs.
AssemblyInput input_of(const std::string& path) {
  AssemblyInput input;
  LineCollector collector;
  LogReader log(path);
  while (const auto event = log.next()) {
    if (event->channel == channel::kLaserLine.name) {
      EXPECT_TRUE(collector.add(piece_of(decode<laser_line_t>(event->bytes))));
    } else if (event->channel == channel::kPanTiltState.name) {
      const auto state = decode<bot_core::joint_state_t>(event->bytes);
      input.angles.push_back({state.utime, state.joint_position[0], state.joint_position[1]});
    } else if (event->channel == channel::kImu.name) {
      const auto imu = decode<bot_core::ins_t>(event->bytes);
      input.orientations.push_back({imu.utime, orientation_of(imu)});
    } else if (event->channel == channel::kSweepMark.name) {
      const auto mark = decode<sweep_mark_t>(event->bytes);
      (mark.mark == sweep_mark_t::STARTED ? input.started : input.ended) = mark.utime;
      input.sweep = mark.sweep;
    }
  }
  EXPECT_TRUE(collector.missing().empty());
  input.lines = collector.take();
  return input;
}

TEST(Simulate, ALogsLinesAssembleToTheCloudOfTheSamePose) {
  const ScratchFolder folder;
  const auto simulate = [&](const std::string& file) {
    return scanway::test::run_scanway(
        {"simulate", "sweep", "--world", "hall", "--seed", "3", "--pose", "-6,0.3,0.5", "--thin", "3", "-o", file});
  };
  ASSERT_EQ(simulate(folder / "a.lcm").status, 0);
  ASSERT_EQ(simulate(folder / "a.pcd").status, 0);
  const AssembledSweep assembled = assemble(input_of(folder / "a.lcm"), simulated_robot());
  const PointCloud expected = read_scan(folder / "a.pcd"), &cloud = assembled.sweep.cloud;
  EXPECT_EQ(assembled.report.lines, 1000);
  EXPECT_EQ(assembled.report.missing_lines, 0);
  EXPECT_FALSE(assembled.report.steadiness.moved);
  ASSERT_LE(cloud.size(), expected.size());
  ASSERT_GE(cloud.size() + 400, expected.size()) << "but for what the last line measures after the pan stands";
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ASSERT_LT((cloud.points[i] - expected.points[i]).norm(), 1e-4F) << i;
    ASSERT_EQ(cloud.intensity[i], expected.intensity[i]);
  }
  SweepConfig thin;
  thin.seed = 3;
  thin.thin = 60;
  const SimulatedSweep truth = simulate_sweep(make_world("hall", 3), {-6, 0.3, 0.5}, simulated_robot(), thin);
  EXPECT_LT(assembled.sweep.R_world_sweep->angularDistance(*truth.sweep.R_world_sweep), radians(0.01L));
}

}  // namespace
}  // namespace scanway::simulator
