#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/cloud/poses_file.h"
#include "common/cloud/read_cloud.h"
#include "modules/mapper/core/map.h"

namespace scanway {
namespace {

const std::string kHalls = SCANWAY_SHARED_DIR "/data/hall_scans_a";

Cell cell_at(double x, double y, double side) {
  return {static_cast<std::int32_t>(std::floor(x / side)), static_cast<std::int32_t>(std::floor(y / side))};
}

/// Whether a path of free cells where the body fits leads from one cell to the other.
bool connected(const CostMap& map, Cell from, Cell to) {
  std::set<Cell> seen{from};
  std::vector<Cell> front{from};
  while (!front.empty()) {
    const Cell cell = front.back();
    front.pop_back();
    if (cell == to) return true;
    for (const auto& [dx, dy] : std::array<std::array<int, 2>, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
      const Cell next{cell.x + dx, cell.y + dy};
      const bool fits = map.state(next) == CellState::free && map.cost(next) != kCostLethal;
      if (fits && seen.insert(next).second) front.push_back(next);
    }
  }
  return false;
}

/// The real halls, all seven scans at their reference poses.
class Halls : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!std::filesystem::exists(kHalls)) return;
    const PosesFile poses = PosesFile::read(kHalls + "/poses_reference.txt");
    map_.emplace(Robot{}, 1);
    Pose X_map_ref = Pose::Identity();
    for (int i = 0; i < 7; ++i) {
      const std::string name = "scan00" + std::to_string(i);
      Sweep sweep;
      sweep.cloud = read_cloud(kHalls + "/" + name + ".pcd");
      if (i == 0) X_map_ref = map_->first_pose(sweep);  // the reference's frame is that of the first scan
      const Pose X_map_scan = X_map_ref * poses.pose_of(name);
      grounds_.push_back(map_->merge(sweep, X_map_scan).ground);
      stands_.emplace_back(X_map_scan.translation());
      for (const auto& p : sweep.cloud.points) points_.emplace_back(X_map_scan * p.cast<double>());
    }
  }
  static void TearDownTestSuite() { map_.reset(), grounds_.clear(), stands_.clear(), points_.clear(); }
  void SetUp() override {
    if (!map_) GTEST_SKIP() << "no " << kHalls;
  }

  static Cell cell_of_stand(std::size_t i) { return cell_at(stands_[i].x(), stands_[i].y(), 0.01); }

  static std::optional<Map> map_;
  static std::vector<GroundReport> grounds_;
  static std::vector<Eigen::Vector3d> stands_, points_;  ///< In the map.
};

std::optional<Map> Halls::map_;
std::vector<GroundReport> Halls::grounds_;
std::vector<Eigen::Vector3d> Halls::stands_, Halls::points_;

TEST_F(Halls, TheFloorIsFreeAndConnectedFromEndToEnd) {
  for (const GroundReport& ground : grounds_) {
    ASSERT_TRUE(ground.plane.has_value());
    EXPECT_NEAR(ground.sensor_height_m, 1.36, 0.02);
  }
  EXPECT_GT((stands_.back() - stands_.front()).norm(), 20.0);
  EXPECT_TRUE(connected(map_->cost_map(), cell_of_stand(0), cell_of_stand(stands_.size() - 1)));
}

TEST_F(Halls, NoSpeckleAroundTheStands) {
  for (std::size_t i = 0; i < stands_.size(); ++i) {
    const Cell stand = cell_of_stand(i);
    int occupied = 0;
    for (std::int32_t y = -100; y <= 100; ++y) {
      for (std::int32_t x = -100; x <= 100; ++x) {
        occupied += map_->cost_map().state({stand.x + x, stand.y + y}) == CellState::occupied ? 1 : 0;
      }
    }
    EXPECT_EQ(occupied, 0) << i;
  }
}

/// What stands by itself and shows points at all heights from 0.2 m to 2 m, found in the points alone: columns of 0.2 m
/// that touch each other, a metre across.
std::vector<std::vector<Cell>> find_pillars(const std::vector<Eigen::Vector3d>& points) {
  std::map<Cell, std::bitset<6>> heights;
  for (const Eigen::Vector3d& p : points) {
    if (p.z() > 0.2 && p.z() < 2.0) heights[cell_at(p.x(), p.y(), 0.2)].set(static_cast<int>((p.z() - 0.2) / 0.3));
  }
  std::set<Cell> full;
  for (const auto& [column, bins] : heights) {
    if (bins.all()) full.insert(column);
  }
  std::vector<std::vector<Cell>> pillars;
  while (!full.empty()) {
    std::vector<Cell> columns{full.extract(full.begin()).value()};
    Cell low = columns[0], high = low;
    for (std::size_t next = 0; next < columns.size(); ++next) {
      const Cell at = columns[next];
      low = {std::min(low.x, at.x), std::min(low.y, at.y)}, high = {std::max(high.x, at.x), std::max(high.y, at.y)};
      for (int i = 0; i < 9; ++i) {
        const Cell other{at.x + i % 3 - 1, at.y + i / 3 - 1};
        if (full.erase(other) > 0) columns.push_back(other);
      }
    }
    if (columns.size() >= 5 && high.x - low.x < 6 && high.y - low.y < 6) pillars.push_back(columns);
  }
  return pillars;
}

TEST_F(Halls, ThePillarsAreOccupied) {
  std::set<Cell> judged;
  int pillars = 0;
  for (const std::vector<Cell>& pillar : find_pillars(points_)) {
    const Eigen::Vector2d place((pillar[0].x + 0.5) * 0.2, (pillar[0].y + 0.5) * 0.2);
    const auto near_by = [&](const Eigen::Vector3d& stand) { return (stand.head<2>() - place).norm() < 15.0; };
    if (std::none_of(stands_.begin(), stands_.end(), near_by)) continue;
    ++pillars;
    judged.insert(pillar.begin(), pillar.end());
  }
  EXPECT_GE(pillars, 8);
  int points = 0, occupied = 0, open = 0, passable = 0;
  for (const Eigen::Vector3d& p : points_) {
    if (p.z() < 0.2 || p.z() > 1.4 || judged.count(cell_at(p.x(), p.y(), 0.2)) == 0) continue;
    const Cell cell = cell_at(p.x(), p.y(), 0.01);
    ++points;
    occupied += map_->cost_map().state(cell) == CellState::occupied ? 1 : 0;
    open += map_->cost_map().state(cell) == CellState::free ? 1 : 0;
    passable += map_->cost_map().cost(cell) == kCostLethal ? 0 : 1;
  }
  EXPECT_GT(points, 1000);
  EXPECT_EQ(passable, 0) << "for the robot's centre";
  EXPECT_GE(occupied, points * 95 / 100);
  EXPECT_LE(open, points * 2 / 100) << "grazed by a later sweep";
}

}  // namespace
}  // namespace scanway
