#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <string>

#include "common/cloud/read_cloud.h"
#include "common/cloud/write_cloud.h"
#include "common/files/input_error.h"
#include "common/files/saved_folder.h"
#include "common/grid/map_file.h"
#include "modules/tools/map/export_map.h"
#include "modules/tools/map/import_map.h"
#include "modules/tools/map/octree_projection.h"
#include "modules/tools/map/save_map.h"
#include "modules/tools/plan/plan.h"
#include "tests/support/command.h"

namespace scanway::tools {
namespace {

using test::read_text;
using test::ScratchFolder;
using test::write_text;

constexpr double kVoxel = 0.05;

/// A floor of 4 m x 3 m at z = 0 that was seen from above, with a wall across it but for a gap, and a shaft in it.
class Room {
 public:
  Room() : tree_(kVoxel) {
    for (int x = 0; x < 80; ++x) {
      for (int y = 0; y < 60; ++y) column(x, y);
    }
    tree_.updateInnerOccupancy();
  }
  octomap::OcTree& tree() { return tree_; }
  static bool is_wall(int x, int y) { return x == 40 && y < 40; }
  static bool is_shaft(int x, int y) { return x >= 10 && x < 14 && y >= 10 && y < 14; }

 private:
  void column(int x, int y) {
    const auto say = [&](int z, bool occupied) {
      tree_.updateNode(
          octomap::OcTreeKey(static_cast<octomap::key_type>(32768 + x), static_cast<octomap::key_type>(32768 + y),
                             static_cast<octomap::key_type>(32768 + z)),
          occupied);
    };
    for (int z = -8; z < 0; ++z) {
      if (is_shaft(x, y)) say(z, false);
    }
    if (!is_shaft(x, y)) say(-1, true);
    for (int z = 0; z < 30; ++z) say(z, is_wall(x, y) && z < 20);
  }

  octomap::OcTree tree_;
};

TEST(ImportMap, ProjectsFloorWallAndShaft) {
  const ScratchFolder scratch;
  Room room;
  room.tree().writeBinary(scratch / "room.bt");
  room.tree().write(scratch / "room.ot");
  for (const char* name : {"room.bt", "room.ot"}) {
    ASSERT_EQ(run_import_map({scratch / name, "", 0.0, scratch / "room.yaml"}), 0);
    const CostMap map = read_map(scratch / "room.yaml");
    EXPECT_DOUBLE_EQ(map.resolution_m, kVoxel);
    for (int x = 0; x < 80; ++x) {
      for (int y = 0; y < 60; ++y) {
        const bool lethal = Room::is_wall(x, y) || Room::is_shaft(x, y);
        EXPECT_EQ(map.state({x, y}), lethal ? CellState::occupied : CellState::free) << name << " " << x << "," << y;
      }
    }
  }
}

TEST(ImportMap, IsPlannedOn) {
  const ScratchFolder scratch;
  Room().tree().writeBinary(scratch / "room.bt");
  run_import_map({scratch / "room.bt", "", 0.0, scratch / "room.yaml"});
  PlanOptions plan;
  plan.map = scratch / "room.yaml";
  plan.start_m = {1.2, 1.5};
  plan.goal_m = {3.2, 0.5};
  plan.output = scratch / "plan";
  EXPECT_EQ(run_plan(plan), 0);
  EXPECT_NE(read_text(scratch / "plan/path.csv").find('\n'), std::string::npos);
}

TEST(ImportMap, NeverTakesUnknownForFree) {
  octomap::OcTree tree(kVoxel);
  tree.updateNode(octomap::point3d(0.02F, 0.02F, 1.0F), false);  // Free, but high above a ground that nobody saw.
  tree.updateNode(octomap::point3d(1.02F, 0.02F, -0.02F), true);
  const ScratchFolder scratch;
  tree.writeBinary(scratch / "sparse.bt");
  run_import_map({scratch / "sparse.bt", "", 0.0, scratch / "sparse.yaml"});
  const CostMap map = read_map(scratch / "sparse.yaml");
  EXPECT_EQ(map.state({0, 0}), CellState::free) << "ground; the picture begins at the first known cell";
  std::size_t known = 0;
  for (const auto& [index, tile] : map.tiles) {
    for (const CellState state : tile.state) known += state != CellState::unknown;
  }
  EXPECT_EQ(known, 1U);
}

TEST(ImportMap, RefusesWhatIsTooLargeAndWhatIsNoMap) {
  const ScratchFolder scratch;
  octomap::OcTree tree(kVoxel);
  tree.updateNode(octomap::point3d(-1000.0F, -1000.0F, 0.5F), true);
  tree.updateNode(octomap::point3d(1000.0F, 1000.0F, 0.5F), true);
  tree.writeBinary(scratch / "wide.bt");
  EXPECT_THROW(run_import_map({scratch / "wide.bt", "", 0.0, scratch / "wide.yaml"}), InputError);
  write_text(scratch / "no.bt", "nothing");
  EXPECT_THROW(run_import_map({scratch / "no.bt", "", 0.0, scratch / "no.yaml"}), InputError);
  EXPECT_THROW(run_import_map({scratch / "no.txt", "", 0.0, scratch / "no.yaml"}), InputError);
  Room().tree().writeBinary(scratch / "room.bt");
  EXPECT_THROW(run_import_map({scratch / "room.bt", "", 100.0, scratch / "high.yaml"}), InputError);
}

class ExportMap : public testing::Test {
 protected:
  ExportMap() : map_(scratch_ / "map") {
    cloud_.points = {{1.0F, 2.0F, 3.0F}, {-1.5F, 0.25F, 0.0F}};
    cloud_.intensity = {7.0F, 200.0F};
    FolderSave save(map_);
    write_pcd(save.files().path_of("map.pcd"), cloud_);
    Room().tree().writeBinary(save.files().path_of("map.bt"));
    CostMap grid;
    grid.set_state({3, 4}, CellState::occupied);
    grid.set_state({-2, 0}, CellState::free);
    write_map(grid, save.files().path_of("costmap.yaml"));
    save.commit();
  }

  const ScratchFolder scratch_;
  std::string map_;
  PointCloud cloud_;
};

TEST_F(ExportMap, GivesEachProductAsItIsInTheMap) {
  for (const std::string end : {"pcd", "bt"}) {
    run_export_map({map_, scratch_ / "out." + end});
    EXPECT_EQ(read_text(scratch_ / "out." + end), read_text(map_ + "/map." + end));
  }
  run_export_map({map_, scratch_ / "out.yaml"});
  EXPECT_EQ(read_text(scratch_ / "out.pgm"), read_text(map_ + "/costmap.pgm"));
  EXPECT_EQ(read_map(scratch_ / "out.yaml").tiles, read_map(map_ + "/costmap.yaml").tiles);
  run_export_map({map_, scratch_ / "out.las"});
  EXPECT_EQ(read_text(scratch_ / "out.las").size(), 227U + 2U * 20U);
}

TEST_F(ExportMap, RefusesWhatIsNotThere) {
  EXPECT_THROW(run_export_map({map_, scratch_ / "out.ply"}), InputError);
  EXPECT_THROW(run_export_map({map_, scratch_ / "out.jpg"}), InputError);
  EXPECT_THROW(run_export_map({scratch_ / "none", scratch_ / "out.pcd"}), InputError);
  EXPECT_EQ(run_check_map(map_), 0);
  write_text(map_ + "/map.bt", "damaged");
  EXPECT_THROW(run_check_map(map_), InputError);
  EXPECT_THROW(run_export_map({map_, scratch_ / "out.pcd"}), InputError) << "a damaged map is not used in part";
}

}  // namespace
}  // namespace scanway::tools
