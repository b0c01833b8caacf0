#include "modules/tools/clouds/import_clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "common/bus/channels.h"
#include "common/bus/log_reader.h"
#include "common/cloud/poses_file.h"
#include "common/cloud/read_cloud.h"
#include "common/cloud/write_cloud.h"
#include "common/config/robot_file.h"
#include "common/files/input_error.h"
#include "common/geometry/pose.h"
#include "common/messages/codec.h"
#include "common/messages/goal_message.h"
#include "common/messages/imu_message.h"
#include "common/messages/object_assembler.h"
#include "common/messages/params_message.h"
#include "common/messages/sweep_message.h"
#include "common/random/random.h"
#include "scanway/reference_pose_t.hpp"
#include "tests/support/command.h"

namespace scanway::tools {
namespace {

namespace fs = std::filesystem;

/// What an imported log says.
struct Imported {
  std::vector<Sweep> sweeps;
  std::vector<Utime> sweep_ends;  ///< Log time of each sweep's last piece.
  std::vector<bot_core::ins_t> imu;
  std::vector<reference_pose_t> references;
  std::vector<goal_t> goals;
  std::vector<params_t> params;
  std::vector<std::string> channels;  ///< Of all events, in order.
  std::vector<Utime> utimes;
};

Imported read_log(const std::string& path) {
  Imported log;
  std::map<std::string, ObjectAssembler> assemblers;
  LogReader reader(path);
  while (const auto event = reader.next()) {
    const std::string channel(event->channel);
    log.channels.push_back(channel);
    log.utimes.push_back(event->utime);
    if (channel == channel::kImu.name) log.imu.push_back(decode<bot_core::ins_t>(event->bytes));
    if (channel == channel::kReferencePose.name) log.references.push_back(decode<reference_pose_t>(event->bytes));
    if (channel == channel::kGoal.name) log.goals.push_back(decode<goal_t>(event->bytes));
    if (!find_channel(channel)->cut) continue;
    const auto object = assemblers[channel].add(decode<piece_t>(event->bytes));
    if (!object) continue;
    if (channel == channel::kParams.name) log.params.push_back(decode<params_t>(object->bytes));
    if (channel == channel::kSweep.name) {
      log.sweeps.push_back(to_sweep(decode<sweep_t>(object->bytes)));
      log.sweep_ends.push_back(event->utime);
    }
  }
  return log;
}

PointCloud random_cloud(std::size_t points, std::uint64_t seed) {
  Random random(seed);
  PointCloud cloud;
  for (std::size_t i = 0; i < points; ++i) {
    cloud.points.emplace_back(static_cast<float>(random.uniform() * 20.0 + 0.5),
                              static_cast<float>(random.normal() * 10.0), static_cast<float>(random.normal()));
    cloud.intensity.push_back(static_cast<float>(random.uniform() * 255.0));
  }
  return cloud;
}

class ImportClouds : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_ / name; }

  std::string write(const std::string& name, const std::string& text) const {
    test::write_text(path(name), text);
    return path(name);
  }

  /// Options for `count` small random clouds, all with poses turned a little against each other.
  ImportCloudsOptions small_clouds(std::size_t count, std::size_t points = 100) const {
    ImportCloudsOptions options;
    std::ostringstream poses;
    poses.precision(17);
    for (std::size_t k = 0; k < count; ++k) {
      const std::string name = "scan" + std::to_string(k);
      options.files.push_back(path(name + ".pcd"));
      write_pcd(options.files.back(), random_cloud(points, k + 1));
      const double a = 0.3 * static_cast<double>(k);
      poses << name << ' ' << std::cos(a) << ' ' << -std::sin(a) << " 0 " << 1.5 * static_cast<double>(k) << ' '
            << std::sin(a) << ' ' << std::cos(a) << " 0 2  0 0 1 -0.125\n";
    }
    options.poses = write("poses.txt", poses.str());
    options.output = path("out.lcmlog");
    return options;
  }

  /// Nothing but what the test itself wrote is in the folder.
  void expect_no_log() const {
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      EXPECT_EQ(entry.path().string().find("out.lcmlog"), std::string::npos) << entry.path();
    }
  }

  test::ScratchFolder folder_;
};

std::string error_of(const ImportCloudsOptions& options) {
  try {
    run_import_clouds(options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST_F(ImportClouds, GivesEveryPointBackBitForBit) {
  const ImportCloudsOptions options = small_clouds(3, 5000);
  ASSERT_EQ(run_import_clouds(options), 0);
  const Imported log = read_log(options.output);
  ASSERT_EQ(log.sweeps.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const PointCloud expected = random_cloud(5000, k + 1);
    EXPECT_EQ(log.sweeps[k].name, "scan" + std::to_string(k));
    EXPECT_EQ(log.sweeps[k].cloud.points, expected.points);
    EXPECT_EQ(log.sweeps[k].cloud.intensity, expected.intensity);
    EXPECT_FALSE(log.sweeps[k].sensor_height_m);
  }
}

TEST_F(ImportClouds, GivesTheSameBytesAgain) {
  ImportCloudsOptions options = small_clouds(3);
  options.heading_sigma_deg = 5.0;
  options.tilt_sigma_deg = 0.5;
  options.goal_m = {3.0, -1.0};
  run_import_clouds(options);
  const std::string first = test::read_text(options.output);
  options.output = path("again.lcmlog");
  run_import_clouds(options);
  EXPECT_EQ(test::read_text(options.output), first);
  options.seed = 2;
  run_import_clouds(options);
  EXPECT_NE(test::read_text(options.output), first);
}

TEST_F(ImportClouds, KeepsTheReferenceAsPrinted) {
  const ImportCloudsOptions options = small_clouds(3);
  run_import_clouds(options);
  const Imported log = read_log(options.output);
  const PosesFile poses = PosesFile::read(options.poses);
  ASSERT_EQ(log.references.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(log.references[k].utime, log.sweeps[k].utime);
    EXPECT_EQ(log.references[k].scan_name, log.sweeps[k].name);
    const Pose& X = poses.pose_of(log.sweeps[k].name);
    for (int i = 0; i < 12; ++i) EXPECT_EQ(log.references[k].T_ref_scan[i], X.matrix()(i / 4, i % 4));
    // Without noise the tracker tells the reference rotation, just before its sweep.
    const Eigen::Matrix3d R = orientation_of(log.imu[k]).toRotationMatrix();
    EXPECT_LT(rotation_angle(R.transpose() * X.linear()), 1e-12);
    EXPECT_LT(log.imu[k].utime, log.sweeps[k].utime);
    EXPECT_GT(log.imu[k].utime, log.sweeps[k].utime - kMicrosecondsPerSecond);
  }
}

TEST_F(ImportClouds, SpacesScansAndPieces) {
  const ImportCloudsOptions options = small_clouds(3, 3000);
  run_import_clouds(options);
  const Imported log = read_log(options.output);
  EXPECT_EQ(log.channels.front(), "PARAMS");
  Utime last_piece = 0;
  for (std::size_t i = 0; i < log.utimes.size(); ++i) {
    EXPECT_GE(log.utimes[i], log.utimes[i == 0 ? 0 : i - 1]);
    if (log.channels[i] != "SWEEP") continue;
    EXPECT_GE(log.utimes[i] - last_piece, 1000);
    last_piece = log.utimes[i];
  }
  for (std::size_t k = 1; k < 3; ++k) {
    EXPECT_EQ(log.sweeps[k].utime - log.sweeps[k - 1].utime, 10 * kMicrosecondsPerSecond);
  }
}

TEST_F(ImportClouds, WaitsForPiecesThatNeedLonger) {
  ImportCloudsOptions options = small_clouds(2, 1'000'000);
  run_import_clouds(options);
  const Imported log = read_log(options.output);
  ASSERT_EQ(log.sweeps.size(), 2u);
  ASSERT_GT(log.sweep_ends[0], log.sweeps[0].utime + 10 * kMicrosecondsPerSecond) << "too small to show it";
  EXPECT_GT(log.imu[1].utime, log.sweep_ends[0]);
  EXPECT_GT(log.sweeps[1].utime, log.sweep_ends[0]);
}

TEST_F(ImportClouds, DisturbsTheTrackerAsAsked) {
  // One file again and again, on a robot that leans by 30 degrees: the world's axes are not the scan's.
  ImportCloudsOptions options = small_clouds(1, 3);
  options.files.assign(400, options.files[0]);
  test::write_text(options.poses, "scan0 1 0 0 0 0 0.8660254038 -0.5 0 0 0.5 0.8660254038 0\n");
  options.heading_sigma_deg = 5.0;
  options.tilt_sigma_deg = 0.5;
  run_import_clouds(options);
  const Imported log = read_log(options.output);
  const Eigen::Matrix3d R_ref = PosesFile::read(options.poses).pose_of("scan0").linear();
  ASSERT_EQ(log.imu.size(), 400u);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), squares = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < 400; ++k) {
    const Eigen::Matrix3d R_measured = orientation_of(log.imu[k]).toRotationMatrix();
    const Eigen::Vector3d w = log_so3(R_measured * R_ref.transpose());
    sum += w;
    squares += w.cwiseProduct(w);
  }
  const Eigen::Vector3d deviation = (squares / 400.0).cwiseSqrt() * 180.0 / M_PI;
  const Eigen::Vector3d mean = sum / 400.0 * 180.0 / M_PI;
  // A deviation of 400 numbers is known to 3.5 %, their mean to 5 %: 4 such errors. World axes, heading last.
  EXPECT_NEAR(deviation.x(), 0.5, 0.07);
  EXPECT_NEAR(deviation.y(), 0.5, 0.07);
  EXPECT_NEAR(deviation.z(), 5.0, 0.7);
  EXPECT_NEAR(mean.x(), 0.0, 0.1);
  EXPECT_NEAR(mean.y(), 0.0, 0.1);
  EXPECT_NEAR(mean.z(), 0.0, 1.0);
}

TEST_F(ImportClouds, WritesGoalHeightAndRobotAheadOfAllScans) {
  ImportCloudsOptions options = small_clouds(2);
  options.goal_m = {3.5, -1.25};
  options.sensor_height_m = 1.4;
  Robot robot;
  robot.name = "other";
  options.robot = write("robot.yaml", robot_text(robot));
  run_import_clouds(options);
  const Imported log = read_log(options.output);
  ASSERT_EQ(log.goals.size(), 1u);
  EXPECT_EQ(goal_of(log.goals[0]), Eigen::Vector2d(3.5, -1.25));
  EXPECT_LT(log.goals[0].utime, log.sweeps[0].utime);
  ASSERT_EQ(log.params.size(), 1u);
  EXPECT_EQ(parse_robot(robot_yaml_of(log.params[0]), "log").name, "other");
  EXPECT_LT(log.params[0].utime, log.sweeps[0].utime);
  for (const Sweep& sweep : log.sweeps) EXPECT_EQ(sweep.sensor_height_m, 1.4);
}

TEST_F(ImportClouds, TellsNoOrientationThatItDoesNotHave) {
  ImportCloudsOptions options = small_clouds(2);
  std::swap(options.orientation, options.poses);
  run_import_clouds(options);
  Imported log = read_log(options.output);
  EXPECT_EQ(log.imu.size(), 2u);
  EXPECT_TRUE(log.references.empty());
  options.orientation.clear();
  run_import_clouds(options);
  log = read_log(options.output);
  EXPECT_EQ(log.sweeps.size(), 2u);
  EXPECT_TRUE(log.imu.empty());
  EXPECT_TRUE(log.references.empty());
}

TEST_F(ImportClouds, LeavesOutWhatIsNearerThanTheSensorMeasures) {
  ImportCloudsOptions options = small_clouds(1, 10);
  PointCloud cloud = random_cloud(10, 1);
  cloud.points[4] = {0.0f, 0.0f, 0.0f};
  cloud.points[7] = {0.1f, -0.2f, 0.1f};
  write_pcd(options.files[0], cloud);
  run_import_clouds(options);
  cloud.points.erase(cloud.points.begin() + 7);
  cloud.points.erase(cloud.points.begin() + 4);
  cloud.intensity.erase(cloud.intensity.begin() + 7);
  cloud.intensity.erase(cloud.intensity.begin() + 4);
  const Imported log = read_log(options.output);
  EXPECT_EQ(log.sweeps[0].cloud.points, cloud.points);
  EXPECT_EQ(log.sweeps[0].cloud.intensity, cloud.intensity);
}

TEST_F(ImportClouds, LeavesNoLogWhenTheThirdFileIsDamaged) {
  const ImportCloudsOptions options = small_clouds(4);
  const std::string whole = test::read_text(options.files[2]);
  write("scan2.pcd", whole.substr(0, whole.size() - 1));
  EXPECT_NE(error_of(options).find("scan2.pcd"), std::string::npos);
  expect_no_log();
  write("scan2.pcd", whole);
  EXPECT_EQ(error_of(options), "");
}

TEST_F(ImportClouds, KeepsAnOlderLogWhenItFails) {
  ImportCloudsOptions options = small_clouds(2);
  run_import_clouds(options);
  const std::string older = test::read_text(options.output);
  options.files[1] = path("missing.pcd");
  EXPECT_NE(error_of(options), "");
  EXPECT_EQ(test::read_text(options.output), older);
}

TEST_F(ImportClouds, NamesTheScanWithoutAPose) {
  ImportCloudsOptions options = small_clouds(3);
  std::string poses = test::read_text(options.poses);
  poses.erase(poses.find("scan1"), poses.find("scan2") - poses.find("scan1"));
  write("poses.txt", poses);
  const std::string error = error_of(options);
  EXPECT_NE(error.find("scan1"), std::string::npos) << error;
  EXPECT_NE(error.find("poses.txt"), std::string::npos) << error;
  expect_no_log();
}

TEST_F(ImportClouds, RefusesWhatCannotBeMeant) {
  const ImportCloudsOptions good = small_clouds(2);
  const auto refused = [&](const auto& change) {
    ImportCloudsOptions options = good;
    change(options);
    return error_of(options);
  };
  EXPECT_NE(refused([](auto& o) { o.files.clear(); }), "");
  EXPECT_NE(refused([](auto& o) { o.orientation = o.poses; }), "");
  EXPECT_NE(refused([](auto& o) { o.heading_sigma_deg = -1.0; }), "");
  EXPECT_NE(refused([](auto& o) { o.tilt_sigma_deg = NAN; }), "");
  EXPECT_NE(refused([](auto& o) { o.sensor_height_m = -0.1; }), "");
  EXPECT_NE(refused([](auto& o) { o.goal_m = {INFINITY, 0.0}; }), "");
  EXPECT_NE(refused([](auto& o) { o.output = o.poses + "/log"; }), "");
  EXPECT_NE(refused([&](auto& o) {
              fs::create_directory(path("other"));
              fs::copy_file(o.files[0], path("other/scan0.pcd"));
              o.files.push_back(path("other/scan0.pcd"));
            }),
            "");
  expect_no_log();
  EXPECT_EQ(error_of(good), "");
}

}  // namespace
}  // namespace scanway::tools
