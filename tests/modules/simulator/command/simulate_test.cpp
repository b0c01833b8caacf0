#include <algorithm>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/bus/channels.h"
#include "common/bus/log_reader.h"
#include "common/cloud/poses_file.h"
#include "common/cloud/read_cloud.h"
#include "common/config/robot_file.h"
#include "common/grid/map_file.h"
#include "common/messages/codec.h"
#include "common/messages/imu_message.h"
#include "modules/simulator/core/simulator.h"
#include "modules/simulator/node/raw_messages.h"
#include "tests/end_to_end/scanway.h"

namespace scanway::simulator {
namespace {

using scanway::test::expect_refused;
using scanway::test::run_scanway;
using scanway::test::ScratchFolder;

scanway::test::CommandResult simulate(const std::string& world, const std::string& pose, const std::string& thin,
                                      const std::string& output) {
  return run_scanway(
      {"simulate", "sweep", "--world", world, "--seed", "2", "--pose", pose, "--thin", thin, "-o", output});
}

TEST(Simulate, WritesACloudThatEveryReaderUnderstands) {
  const ScratchFolder folder;
  const std::string file = folder / "a.pcd";
  ASSERT_EQ(simulate("hall", "-6,0.3,0.5", "8", file).status, 0);
  const PointCloud cloud = read_scan(file);
  SweepConfig config;
  config.seed = 2;
  config.thin = 8;
  const SimulatedSweep same = simulate_sweep(make_world("hall", 2), {-6, 0.3, 0.5}, simulated_robot(), config);
  EXPECT_EQ(cloud.points, same.sweep.cloud.points);
  EXPECT_EQ(cloud.intensity, same.sweep.cloud.intensity);
  EXPECT_TRUE(PosesFile::read(file + ".pose").pose_of("a").isApprox(same.X_world_base, 1e-12));
  EXPECT_TRUE(PosesFile::read(file + ".orientation")
                  .pose_of("a")
                  .linear()
                  .isApprox(same.sweep.R_world_sweep->toRotationMatrix(), 1e-9));
  EXPECT_NE(scanway::test::read_text(file).find("FIELDS x y z intensity label time_us"), std::string::npos);
}

TEST(Simulate, TwoYardSweepsTenMetresApartRegister) {
  const ScratchFolder folder;
  const std::string target = folder / "target.pcd", source = folder / "source.pcd";
  ASSERT_EQ(simulate("yard", "-6,1.5,0.3", "4", target).status, 0);
  ASSERT_EQ(simulate("yard", "4,1.5,-0.4", "4", source).status, 0);
  const auto pose_of = [](const std::string& file, const std::string& ending) {
    return PosesFile::read(file + ending).pose_of(scan_name(file));
  };
  const Eigen::Quaterniond R((pose_of(target, ".orientation").inverse() * pose_of(source, ".orientation")).linear());
  const std::string wxyz =
      std::to_string(R.w()) + "," + std::to_string(R.x()) + "," + std::to_string(R.y()) + "," + std::to_string(R.z());
  const auto result = run_scanway({"register", source, target, "--orientation", wxyz, "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["verdict"], "accepted");
  Pose T = Pose::Identity();
  for (int i = 0; i < 12; ++i)
    T.matrix()(i / 4, i % 4) = json["T_target_source"][static_cast<std::size_t>(i)].get<double>();
  const Pose truth = pose_of(target, ".pose").inverse() * pose_of(source, ".pose");
  const Pose error = truth.inverse() * T;
  EXPECT_NEAR(truth.translation().norm(), 10.0, 0.05);
  EXPECT_LT(error.translation().norm(), 0.1);
  EXPECT_LT(rotation_angle(error.linear()), radians(0.5L));
}

/// A log's messages by channel.
std::map<std::string, std::vector<std::vector<std::uint8_t>>> messages_of(const std::string& path) {
  LogReader log(path);
  std::map<std::string, std::vector<std::vector<std::uint8_t>>> messages;
  Utime last = 0;
  while (const auto event = log.next()) {
    EXPECT_GE(event->utime, last);
    last = event->utime;
    EXPECT_LE(event->bytes.size(), 1300U);
    messages[std::string(event->channel)].emplace_back(event->bytes.begin(), event->bytes.end());
  }
  EXPECT_EQ(log.trouble(), "");
  return messages;
}

TEST(Simulate, ALogHoldsWhatTheBridgesWouldSay) {
  const ScratchFolder folder;
  const std::string file = folder / "raw.lcm";
  ASSERT_EQ(run_scanway({"simulate", "sweep", "--world", "rubble", "--seed", "2", "--pose", "-8,0.6,0", "--pose",
                         "-2,0.6,1", "--thin", "20", "-o", file})
                .status,
            0);
  const auto messages = messages_of(file);
  const auto count = [&](const Channel& channel) { return messages.at(std::string(channel.name)).size(); };
  EXPECT_EQ(count(channel::kLaserLine), 2U * 150U) << "58 beams fit one piece";
  EXPECT_EQ(count(channel::kPanTiltState), 2U * (121'500 / 20 + 1));
  EXPECT_EQ(count(channel::kImu), 2U * (121'500 / 10 + 1));
  ASSERT_EQ(count(channel::kSweepMark), 4U);
  EXPECT_GE(count(channel::kParams), 1U);

  const World world = make_world("rubble", 2);
  const Stand stand = stand_at(world, simulated_robot(), {-8, 0.6, 0});
  SweepConfig config;
  config.seed = 2;
  config.thin = 20;
  const RawSweep raw = simulate_lines(world, simulated_robot(), stand.X_world_base, config);
  const auto& lines = messages.at("LASER_LINE");
  std::int64_t last = -1;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = decode<laser_line_t>(lines[i]);
    EXPECT_EQ(line.line, ++last) << "the numbering goes on over both sweeps";
    ASSERT_EQ(line.nbeams, 58);
    ASSERT_EQ(line.nbeams_of_line, 58);
    EXPECT_NEAR(line.start_angle_rad, radians(-5), 1e-12) << "as the scanner counts";
    EXPECT_NEAR(line.angle_step_rad, radians(20) / 6, 1e-12);
    EXPECT_NEAR(line.beam_period_us, 20 * 1e6 / 25 / 2160, 1e-9);
    if (i >= 150) continue;
    for (int beam = 0; beam < line.nbeams; ++beam) {
      const auto range = static_cast<std::uint16_t>(line.range_count[static_cast<std::size_t>(beam)]);
      ASSERT_EQ(range, raw.reading(static_cast<int>(i), beam).range_count);
    }
  }
  const auto start = decode<sweep_mark_t>(messages.at("SWEEP_MARK")[0]),
             end = decode<sweep_mark_t>(messages.at("SWEEP_MARK")[1]);
  EXPECT_EQ(start.mark, sweep_mark_t::STARTED);
  EXPECT_EQ(end.mark, sweep_mark_t::ENDED);
  EXPECT_EQ(end.utime - start.utime, 120 * kMicrosecondsPerSecond);
  EXPECT_EQ(decode<sweep_mark_t>(messages.at("SWEEP_MARK")[2]).sweep, 2);
  for (const auto& bytes : messages.at("PAN_TILT_STATE")) {
    const auto state = decode<bot_core::joint_state_t>(bytes);
    if (state.utime < start.utime || state.utime > end.utime) continue;
    ASSERT_NEAR(state.joint_position[0], -M_PI + radians(3) * to_seconds(state.utime - start.utime), 1e-6);
  }
  EXPECT_EQ(PosesFile::read(file + ".pose").size(), 2U);
  EXPECT_EQ(run_scanway({"info", file}).status, 0);
}

TEST(Simulate, TruthBecomesAMap) {
  const ScratchFolder folder;
  const std::string file = folder / "truth.yaml";
  ASSERT_EQ(
      run_scanway({"simulate", "truth", "--world", "trench", "--seed", "3", "--resolution", "0.02", "-o", file}).status,
      0);
  const CostMap map = read_map(file), drops = read_map(folder / "truth_drop_off.yaml");
  const TruthGrid truth = make_truth(make_world("trench", 3), simulated_robot().body, 0.02);
  int drop_offs = 0;
  for (double x = -21; x < 21; x += 0.1) {
    for (double y = -17; y < 17; y += 0.1) {
      const Cell cell{static_cast<std::int32_t>(std::floor((x - map.origin_x_m) / 0.02 + 1e-6)),
                      static_cast<std::int32_t>(std::floor((y - map.origin_y_m) / 0.02 + 1e-6))};
      const Cell world_cell{static_cast<std::int32_t>(std::lround(map.origin_x_m / 0.02)) + cell.x,
                            static_cast<std::int32_t>(std::lround(map.origin_y_m / 0.02)) + cell.y};
      const CellTruth exact = truth.at(world_cell);
      drop_offs += exact == CellTruth::drop_off ? 1 : 0;
      ASSERT_EQ(map.state(cell) == CellState::free, exact == CellTruth::free) << x << " " << y;
      ASSERT_EQ(drops.state(cell) == CellState::occupied, exact == CellTruth::drop_off) << x << " " << y;
      ASSERT_EQ(map.state(cell) == CellState::unknown, exact == CellTruth::unknown);
    }
  }
  EXPECT_GT(drop_offs, 20);
}

TEST(Simulate, SaysWhatIsWrong) {
  const ScratchFolder folder;
  expect_refused(simulate("hall", "-18,5,0", "8", folder / "a.pcd"), "in a wall");
  expect_refused(simulate("hall", "-18,5,0", "8", folder / "a.pcd"), "a free place in this world is -21.00,0.00");
  expect_refused(simulate("hall", "900,5,0", "8", folder / "a.pcd"), "outside the world");
  expect_refused(simulate("hall", "1,2", "8", folder / "a.pcd"), "not x,y,yaw");
  expect_refused(simulate("hall", "1,2,nan", "8", folder / "a.pcd"), "not x,y,yaw");
  expect_refused(simulate("moon", "1,2,3", "8", folder / "a.pcd"), "the worlds are yard, street");
  expect_refused(simulate("hall", "0,0,0", "8", folder / "a.ply"), "*.pcd");
  expect_refused(simulate("hall", "0,0,0", "0", folder / "a.pcd"), "--thin");
  expect_refused(simulate("hall", "0,0,0", "8", folder / "no/a.pcd"), "no");
  EXPECT_EQ(run_scanway({"simulate", "worlds"}).status, 0);
}

TEST(Simulate, TheRobotFileOfTheSimulatedRobotIsTheDefault) {
  const Robot robot = load_robot(std::string(SCANWAY_SOURCE_DIR) + "/launch/robots/era_mobi_simulated.yaml");
  EXPECT_EQ(robot, simulated_robot());
}

}  // namespace
}  // namespace scanway::simulator
