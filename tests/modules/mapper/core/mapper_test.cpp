#include "modules/mapper/core/mapper.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "common/random/random.h"
#include "tests/modules/mapper/core/costmap/scene.h"

namespace scanway {
namespace {

using testing::furnished_room;
using testing::scan;

/// A sweep of the furnished room from a robot at (x, y), turned by `heading`, in the robot's own frame.
Sweep sweep_at(double x, double y, double heading, const std::string& name) {
  Sweep sweep = scan(furnished_room(), {x, y, 1.3}, 0.5, 0.5, 0.005, 3);
  Pose X_room_sweep = Pose::Identity();
  X_room_sweep.linear() = rotation_about_z(heading);
  X_room_sweep.translation() = sweep.origin;
  const Pose X_sweep_room = X_room_sweep.inverse();
  for (Eigen::Vector3f& p : sweep.cloud.points) p = (X_sweep_room * p.cast<double>()).cast<float>();
  sweep.origin.setZero();
  sweep.name = name;
  sweep.R_world_sweep = Eigen::Quaterniond(X_room_sweep.linear());
  return sweep;
}

Sweep junk() {
  Sweep sweep;
  sweep.name = "junk";
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d p(random.normal() * 5.0, random.normal() * 5.0, random.normal() * 5.0);
    sweep.cloud.points.push_back(p.cast<float>());
  }
  return sweep;
}

/// Every product, byte for byte.
std::string products(const Mapper& mapper) {
  std::string bytes;
  const auto append = [&](const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); };
  const PointCloud cloud = mapper.map().cloud().centroids();
  append(cloud.points.data(), cloud.size() * sizeof(Eigen::Vector3f));
  bytes += mapper.map().occupancy_tree().ot_bytes() + mapper.map().occupancy_tree().bt_bytes();
  for (const auto& [index, tile] : mapper.map().cost_map().tiles) {
    append(&index, sizeof(index));
    append(tile.state.data(), sizeof(tile.state));
    append(tile.cost.data(), sizeof(tile.cost));
  }
  for (const TrajectoryPoint& point : mapper.trajectory()) {
    append(&point.utime, sizeof(point.utime));
    append(point.X_map_sweep.data(), 16 * sizeof(double));
  }
  return bytes;
}

TEST(Mapper, TheFirstSweepLiesLevelOnTheGround) {
  Sweep sweep = sweep_at(0.3, -0.2, 0.7, "first");
  const Eigen::Matrix3d tilt = exp_so3({0.05, -0.03, 0.0});  // the robot stands askew, and the tracker knows it
  for (Eigen::Vector3f& p : sweep.cloud.points) p = (tilt.transpose() * p.cast<double>()).cast<float>();
  sweep.R_world_sweep = Eigen::Quaterniond(rotation_about_z(0.7) * tilt);
  Mapper mapper(Robot{});
  const SweepResult result = mapper.add(sweep);
  ASSERT_EQ(result.verdict, Verdict::accepted) << result.reason;
  ASSERT_TRUE(result.change.ground.plane.has_value());
  EXPECT_NEAR(result.X_map_sweep.translation().z(), 1.3, 0.003);
  EXPECT_NEAR(result.change.ground.plane->height_at(0.0, 0.0), 0.0, 1e-6);
  EXPECT_NEAR(heading_of(result.X_map_sweep.linear()), 0.0, 1e-9) << "x is ahead of the first sweep";
  EXPECT_NEAR((result.X_map_sweep.linear().col(2) - tilt.col(2)).head<2>().norm(), 0.0, 0.1);
  const Eigen::Vector3d up = result.X_map_sweep.linear().transpose() * Eigen::Vector3d::UnitZ();
  EXPECT_NEAR((up - tilt.transpose() * Eigen::Vector3d::UnitZ()).norm(), 0.0, 1e-9) << "z is along gravity";
}

TEST(Mapper, ASecondSweepFindsItsPlaceAndARefusedOneChangesNothing) {
  Mapper mapper(Robot{});
  mapper.add(sweep_at(0.3, -0.2, 0.0, "first"));
  const SweepResult second = mapper.add(sweep_at(1.0, 0.4, 0.3, "second"));
  ASSERT_EQ(second.verdict, Verdict::accepted) << second.reason;
  EXPECT_EQ(second.target, "first");
  EXPECT_NEAR((second.X_map_sweep.translation().head<2>() - Eigen::Vector2d(0.7, 0.6)).norm(), 0.0, 0.02);
  EXPECT_NEAR(heading_of(second.X_map_sweep.linear()), 0.3, 0.005);
  EXPECT_EQ(second.change.version, 2u);
  EXPECT_FALSE(second.change.changed_tiles.empty());

  const std::string before = products(mapper);
  const SweepResult refused = mapper.add(junk());
  EXPECT_EQ(refused.verdict, Verdict::refused);
  EXPECT_FALSE(refused.reason.empty());
  EXPECT_EQ(refused.change.version, 2u);
  EXPECT_TRUE(refused.change.changed_tiles.empty());
  EXPECT_TRUE(products(mapper) == before);
  EXPECT_EQ(mapper.results().size(), 3u);
  EXPECT_EQ(mapper.trajectory().size(), 2u);
}

TEST(Mapper, AnEmptyFirstSweepIsRefusedAndTheNextBeginsTheMap) {
  Mapper mapper(Robot{});
  EXPECT_EQ(mapper.add(Sweep{}).verdict, Verdict::refused);
  EXPECT_EQ(mapper.map().version(), 0u);
  EXPECT_EQ(mapper.add(sweep_at(0.3, -0.2, 0.0, "first")).verdict, Verdict::accepted);
}

TEST(Mapper, WithoutGroundTheCostMapStaysAsItWas) {
  testing::Scene walls;  // seen from high above: nothing below the sensor but walls
  walls.boxes.push_back({{-4.0, -4.0, -50.0}, {-3.9, 4.0, 50.0}});
  walls.boxes.push_back({{3.9, -4.0, -50.0}, {4.0, 4.0, 50.0}});
  Sweep sweep = scan(walls, {0, 0, 40.0}, 0.5, 0.5, 0.0, 1);
  sweep.name = "shaft";
  std::erase_if(sweep.cloud.points, [](const Eigen::Vector3f& p) { return p.z() < 20.0f; });
  Mapper mapper(Robot{});
  const SweepResult result = mapper.add(sweep);
  EXPECT_EQ(result.verdict, Verdict::accepted);
  EXPECT_FALSE(result.change.ground.plane.has_value());
  EXPECT_NE(result.reason.find("No ground was found: the cost map does not show this sweep."), std::string::npos);
  EXPECT_TRUE(mapper.map().cost_map().tiles.empty());
  EXPECT_GT(mapper.map().cloud().size(), 0u);
}

TEST(Mapper, TheSameBytesForEveryNumberOfThreads) {
  std::vector<std::string> all;
  for (const std::size_t threads : {1, 2, 3}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Mapper mapper(Robot{});
    mapper.add(sweep_at(0.3, -0.2, 0.0, "first"));
    mapper.add(sweep_at(1.0, 0.4, 0.3, "second"));
    all.push_back(products(mapper));
  }
  EXPECT_TRUE(all[0] == all[1]);
  EXPECT_TRUE(all[0] == all[2]);
}

/// A mapper that tolerates no move at all.
Mapper strict_mapper() { return Mapper(Robot{}, 1, {-1.0, -1.0}); }

TEST(Mapper, WhenPosesMoveTheProductsFollow) {
  const std::vector<Sweep> sweeps = {sweep_at(0.3, -0.2, 0.0, "first"), sweep_at(1.0, 0.4, 0.3, "second"),
                                     sweep_at(0.5, 0.3, -0.4, "third")};
  Mapper mapper = strict_mapper();
  std::map<Cell, CostTile> known;  // What a subscriber has who is told of each change.
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const SweepResult result = mapper.add(sweeps[i]);
    ASSERT_EQ(result.verdict, Verdict::accepted) << result.reason;
    EXPECT_EQ(result.correction.remade, i);
    EXPECT_EQ(result.change.version, i + 1);
    const auto& tiles = mapper.map().cost_map().tiles;
    for (const Cell& changed : result.change.changed_tiles) {
      known.erase(changed);
      if (const auto tile = tiles.find(changed); tile != tiles.end()) known.insert(*tile);
    }
    EXPECT_TRUE(known == tiles) << "after " << sweeps[i].name;
  }
  EXPECT_EQ(mapper.graph().graph().edges.size(), 3u) << "each is registered to all that overlap it";
  Map anew(Robot{}, 1);
  for (std::size_t i = 0; i < sweeps.size(); ++i) anew.merge(sweeps[i], mapper.trajectory()[i].X_map_sweep);
  EXPECT_TRUE(anew.cost_map().tiles == mapper.map().cost_map().tiles);
  EXPECT_EQ(anew.occupancy_tree().ot_bytes(), mapper.map().occupancy_tree().ot_bytes());
  EXPECT_EQ(anew.cloud().centroids().points, mapper.map().cloud().centroids().points);
}

TEST(Mapper, AnotherSessionIsFoundInTheMapWhateverItsHeading) {
  Mapper mapper(Robot{});
  mapper.add(sweep_at(0.3, -0.2, 0.0, "first"));
  mapper.add(sweep_at(1.0, 0.4, 0.3, "second"));
  mapper.begin_session();
  EXPECT_EQ(mapper.map().version(), 1u) << "versions are counted anew";

  const std::string before = products(mapper);
  const SweepResult elsewhere = mapper.add(junk());
  EXPECT_EQ(elsewhere.verdict, Verdict::refused);
  EXPECT_NE(elsewhere.reason.find("Not found in the map that it should continue"), std::string::npos);
  EXPECT_TRUE(products(mapper) == before);

  Sweep later = sweep_at(0.6, 0.1, 1.2, "later");
  later.R_world_sweep = Eigen::Quaterniond(rotation_about_z(2.0)) * *later.R_world_sweep;
  const SweepResult found = mapper.add(later);
  ASSERT_EQ(found.verdict, Verdict::accepted) << found.reason;
  EXPECT_NEAR((found.X_map_sweep.translation().head<2>() - Eigen::Vector2d(0.3, 0.3)).norm(), 0.0, 0.02);
  EXPECT_NEAR(heading_of(found.X_map_sweep.linear()), 1.2, 0.005);
  EXPECT_EQ(found.change.version, 2u);
  Sweep next = sweep_at(0.9, -0.1, 1.0, "next");
  next.R_world_sweep = Eigen::Quaterniond(rotation_about_z(2.0)) * *next.R_world_sweep;
  EXPECT_EQ(mapper.add(next).verdict, Verdict::accepted);
}

/// Whether a registration to or from the sweep still says anything.
bool tells(const Mapper& mapper, std::size_t sweep) {
  const std::vector<GraphEdge>& edges = mapper.graph().graph().edges;
  return std::any_of(edges.begin(), edges.end(),
                     [&](const GraphEdge& edge) { return !edge.seam && (edge.from == sweep || edge.to == sweep); });
}

TEST(Mapper, NothingIsRegisteredToASweepThatIsWithdrawn) {
  Mapper mapper(Robot{});
  mapper.add(sweep_at(0.3, -0.2, 0.0, "first"));
  mapper.add(sweep_at(1.0, 0.4, 0.3, "second"));
  const Pose held = mapper.graph().sweeps()[0].X_map_sweep;
  ASSERT_TRUE(mapper.withdraw("second").done);
  const SweepResult third = mapper.add(sweep_at(1.0, 0.4, 0.3, "third"));
  ASSERT_EQ(third.verdict, Verdict::accepted) << third.reason;
  EXPECT_EQ(third.target, "first") << "though it was taken where the second was";
  EXPECT_FALSE(tells(mapper, 1));
  EXPECT_EQ(mapper.graph().sweeps()[0].X_map_sweep.matrix(), held.matrix());

  ASSERT_TRUE(mapper.withdraw("first").done);
  const SweepResult fourth = mapper.add(sweep_at(0.5, 0.3, -0.4, "fourth"));
  ASSERT_EQ(fourth.verdict, Verdict::accepted) << fourth.reason;
  EXPECT_EQ(fourth.target, "third");
  EXPECT_FALSE(tells(mapper, 0));
  EXPECT_LT((mapper.graph().sweeps()[2].X_map_sweep.matrix() - third.X_map_sweep.matrix()).norm(), 1e-6);

  ASSERT_TRUE(mapper.withdraw("third").done && mapper.withdraw("fourth").done);
  const SweepResult fifth = mapper.add(sweep_at(0.3, -0.2, 0.0, "fifth"));
  EXPECT_EQ(fifth.verdict, Verdict::accepted);
  EXPECT_EQ(fifth.target, "") << "the map begins anew";
  EXPECT_EQ(mapper.add(sweep_at(1.0, 0.4, 0.3, "sixth")).target, "fifth");
}

TEST(Map, PaperProjectionLeavesNothingUnknownWithinWhatWasSeen) {
  Robot robot;
  robot.mapping.paper_projection = true;
  robot.mapping.embodiment = Embodiment::paper;
  Map map(robot, 1);
  const Sweep sweep = sweep_at(0.3, -0.2, 0.0, "first");
  map.merge(sweep, map.first_pose(sweep));
  const auto state = [&](double x, double y) {  // in the room; the map begins at the sweep
    return map.cost_map().state({static_cast<std::int32_t>(std::floor((x - 0.3) * 100.0)),
                                 static_cast<std::int32_t>(std::floor((y + 0.2) * 100.0))});
  };
  int occupied = 0;
  for (double x = -2.9; x < 4.9; x += 0.05) {
    for (double y = -2.4; y < 2.4; y += 0.05) {
      EXPECT_NE(state(x, y), CellState::unknown) << x << " " << y;
      occupied += state(x, y) == CellState::occupied ? 1 : 0;
    }
  }
  EXPECT_GT(occupied, 20) << "table, slab of 5 cm";
  EXPECT_EQ(state(1.9, -1.3), CellState::free) << "the slab of 2 cm is within the band";
  EXPECT_EQ(state(0.5, -2.35), CellState::free) << "the shelf is above the body";
}

}  // namespace
}  // namespace scanway
