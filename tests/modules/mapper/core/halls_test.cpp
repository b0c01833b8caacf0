#include <array>
#include <cmath>
#include <filesystem>
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

Cell cell_under(const Pose& X_map_scan) {
  return {static_cast<std::int32_t>(std::floor(X_map_scan.translation().x() / 0.01)),
          static_cast<std::int32_t>(std::floor(X_map_scan.translation().y() / 0.01))};
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

TEST(Halls, TheFloorIsFreeAndConnectedFromScanToScan) {
  if (!std::filesystem::exists(kHalls)) GTEST_SKIP() << "no " << kHalls;
  const PosesFile poses = PosesFile::read(kHalls + "/poses_reference.txt");
  Map map(Robot{}, 1);
  Pose X_map_ref = Pose::Identity();
  std::vector<Cell> stands;
  for (const std::string name : {"scan000", "scan001", "scan002", "scan003"}) {
    Sweep sweep;
    sweep.cloud = read_cloud(kHalls + "/" + name + ".pcd");
    if (stands.empty()) X_map_ref = map.first_pose(sweep);  // the reference's frame is that of the first scan
    const Pose X_map_scan = X_map_ref * poses.pose_of(name);
    const MapChange change = map.merge(sweep, X_map_scan);
    ASSERT_TRUE(change.ground.plane.has_value());
    EXPECT_NEAR(change.ground.sensor_height_m, 1.36, 0.02);
    stands.push_back(cell_under(X_map_scan));
  }
  for (std::size_t i = 1; i < stands.size(); ++i) EXPECT_TRUE(connected(map.cost_map(), stands[i - 1], stands[i])) << i;

  // No speckle: around each stand, the floor of 2 m across holds nothing.
  for (const Cell& stand : stands) {
    int occupied = 0;
    for (std::int32_t y = -100; y <= 100; ++y) {
      for (std::int32_t x = -100; x <= 100; ++x) {
        occupied += map.cost_map().state({stand.x + x, stand.y + y}) == CellState::occupied ? 1 : 0;
      }
    }
    EXPECT_EQ(occupied, 0);
  }
}

}  // namespace
}  // namespace scanway
