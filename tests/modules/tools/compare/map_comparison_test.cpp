// The comparison of a cost map with the truth, against a second computation of each of its parts: a court with one box,
// whose shadow and cells can be written down.
#include "modules/tools/compare/cells/map_comparison.h"

#include <cmath>

#include <gtest/gtest.h>

#include "common/random/random.h"
#include "modules/simulator/core/world/ground_plan.h"

namespace scanway::tools {
namespace {

using namespace scanway::simulator;
using Eigen::Vector3d;

const Rectangle kCourt{{-3.0, -3.0}, {3.0, 3.0}};
const Vector3d kBoxLow(0.51, -0.41, 0.0), kBoxHigh(0.89, 0.59, 0.8);
const Vector3d kSensor(0.0, 0.0, 0.55);  // In base.

World court() {
  World world;
  world.extent = kCourt;
  GroundPlan plan;
  plan.extent = kCourt;
  world.ground = plan.mesh();
  add_block(world.objects, kBoxLow, kBoxHigh, {Material::wood, Label::furniture});
  return world;
}

Pose pose(double x, double y, double heading) {
  Pose X = Pose::Identity();
  X.linear() = rotation_about_z(heading);
  X.translation() = Vector3d(x, y, 0.0);
  return X;
}

/// Some points on the ground, some over it, in `base`.
Sweep sweep_at(const Pose& X_world_base, std::uint64_t seed) {
  Random random(seed);
  Sweep sweep;
  sweep.origin = kSensor;
  for (int i = 0; i < 60; ++i) {
    const double height = i % 6 == 0 ? 0.2 : 0.02 * (random.uniform() - 0.5);
    const Vector3d p(6 * random.uniform() - 3, 6 * random.uniform() - 3, height);
    sweep.cloud.points.push_back((X_world_base.inverse() * p).cast<float>());
  }
  return sweep;
}

/// By slabs: how far the straight way from a to b keeps from the box; below 0 it goes through.
bool box_between(const Vector3d& a, const Vector3d& b, double margin) {
  double enter = 0.0, leave = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = kBoxLow[axis] - margin, high = kBoxHigh[axis] + margin, way = b[axis] - a[axis];
    if (std::fabs(way) < 1e-12) {
      if (a[axis] < low || a[axis] > high) return false;
      continue;
    }
    const double t0 = (low - a[axis]) / way, t1 = (high - a[axis]) / way;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return enter <= leave;
}

TEST(SeenGround, IsNearAPointOnTheGroundAndInSight) {
  const World world = court();
  Robot robot;  // It does not say where its laser is: no body of its own in view.
  const CellWindow window{0.02, -150, -150, 150, 150};
  const Pose X_a = pose(-1.0, 0.2, 0.4), X_b = pose(2.0, 1.0, -2.0);
  const Sweep a = sweep_at(X_a, 1), b = sweep_at(X_b, 2);
  const SeenGround seen = seen_ground(world, robot, {{&a, X_a}, {&b, X_b}}, window);
  int near_cells = 0, hidden = 0;
  Random random(5);
  for (int i = 0; i < 20'000; ++i) {
    const auto x = static_cast<std::int32_t>(random.below(300)) - 150,
               y = static_cast<std::int32_t>(random.below(300)) - 150;
    const Vector3d centre(window.centre(x), window.centre(y), 0.005);
    int near = 0, visible = 0;
    bool sure = true;
    for (const auto& [sweep, X] : {std::pair{&a, X_a}, std::pair{&b, X_b}}) {
      bool is_near = false;
      for (const auto& point : sweep->cloud.points) {
        const Vector3d p = X * point.cast<double>();
        const double dx = (std::floor(p.x() / 0.02) - x) * 0.02, dy = (std::floor(p.y() / 0.02) - y) * 0.02;
        is_near |= std::fabs(p.z()) <= 0.03 && std::hypot(dx, dy) <= kGroundReach_m + 1e-9;
      }
      if (!is_near) continue;
      ++near;
      const Vector3d sensor = X * kSensor;
      if (!box_between(sensor, centre, 0.0)) ++visible;
      sure &= box_between(sensor, centre, 1e-3) == box_between(sensor, centre, -1e-3);
    }
    ASSERT_EQ(seen.near[window.index(x, y)], near) << x << " " << y;
    near_cells += near;
    if (!sure) continue;
    ASSERT_EQ(seen.visible[window.index(x, y)], visible) << x << " " << y;
    hidden += near - visible;
  }
  EXPECT_GT(near_cells, 2000);
  EXPECT_GT(hidden, 100);
}

TEST(MapComparison, CountsCellByCellWhereverTheMapLies) {
  const World world = court();
  Robot robot;
  const TruthGrid truth = make_truth(world, robot.body, 0.02);
  const CellWindow window{0.02, truth.low.x, truth.low.y, truth.low.x + truth.width, truth.low.y + truth.height};
  SeenGround seen{window, std::vector<std::uint8_t>(window.size()), std::vector<std::uint8_t>(window.size())};
  Random random(9);
  for (std::size_t i = 0; i < window.size(); ++i) {
    seen.near[i] = static_cast<std::uint8_t>(random.below(4));
    seen.visible[i] = static_cast<std::uint8_t>(random.below(seen.near[i] + 1U));
  }
  CostMap map;
  map.resolution_m = 0.02;
  map.origin_x_m = -1.0;
  map.origin_y_m = 0.5;
  for (int y = -250; y < 250; ++y) {
    for (int x = -250; x < 250; ++x) {
      map.set_state({x, y}, random.below(50) == 0 ? CellState::occupied : static_cast<CellState>(random.below(2)));
    }
  }
  const Pose X_map_world = pose(0.3, -0.7, 0.6);
  const MapComparison counted = compare(map, X_map_world, truth, seen);

  CellCounts one, two;
  for (int y = window.low_y; y < window.high_y; ++y) {
    for (int x = window.low_x; x < window.high_x; ++x) {
      const double wx = (x + 0.5) * 0.02, wy = (y + 0.5) * 0.02, c = std::cos(0.6), s = std::sin(0.6);
      const int mx = static_cast<int>(std::floor((c * wx - s * wy + 0.3 + 1.0) / 0.02));
      const int my = static_cast<int>(std::floor((s * wx + c * wy - 0.7 - 0.5) / 0.02));
      if (!kCourt.contains(wx, wy)) continue;
      const bool in_box = x >= 25 && x <= 44 && y >= -21 && y <= 29;  // The cells that the box reaches into.
      const std::size_t i = window.index(x, y);
      const int sweeps = in_box ? seen.near[i] : seen.visible[i];
      if (sweeps == 0) continue;
      CellCounts& counts = sweeps > 1 ? two : one;
      const CellState state = map.state({mx, my});
      (in_box ? counts.occupied : counts.free) += 1;
      if (!in_box && state == CellState::occupied) ++counts.free_called_occupied;
      if (!in_box && state == CellState::unknown) ++counts.free_called_unknown;
      if (!in_box || state != CellState::free) continue;
      ++counts.occupied_called_free;
      const auto occupied = [&](int dx, int dy) { return map.state({mx + dx, my + dy}) == CellState::occupied; };
      if (!occupied(0, 0) && !occupied(1, 0) && !occupied(-1, 0) && !occupied(0, 1) && !occupied(0, -1)) {
        ++counts.occupied_unmarked;  // 3 cm are one cell of 2 cm, straight ahead.
      }
    }
  }
  EXPECT_EQ(counted.one, one);
  EXPECT_EQ(counted.two, two);
  EXPECT_GT(two.occupied_unmarked, 100);
  EXPECT_GT(two.free_lost(), 1000);
}

TEST(MapComparison, AMapThatIsTheTruthLosesAndMissesNothing) {
  const World world = court();
  Robot robot;
  const TruthGrid truth = make_truth(world, robot.body, 0.02);
  const CellWindow window{0.02, truth.low.x, truth.low.y, truth.low.x + truth.width, truth.low.y + truth.height};
  const SeenGround all{window, std::vector<std::uint8_t>(window.size(), 2),
                       std::vector<std::uint8_t>(window.size(), 2)};
  const MapComparison counted = compare(to_cost_map(truth), Pose::Identity(), truth, all);
  EXPECT_EQ(counted.two.free_lost(), 0);
  EXPECT_EQ(counted.two.occupied_called_free, 0);
  EXPECT_EQ(counted.two.free + counted.two.occupied, 300 * 300);
  EXPECT_EQ(counted.two.occupied, 20 * 51);
  EXPECT_EQ(counted.one, CellCounts{});
}

}  // namespace
}  // namespace scanway::tools
