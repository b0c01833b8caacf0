#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "common/random/random.h"
#include "modules/simulator/core/world/things.h"
#include "tests/modules/simulator/core/test_worlds.h"

namespace scanway::simulator::test {
namespace {

using Eigen::Vector3d;

/// Height at which the upright line through (x, y) meets the triangle, by barycentric coordinates; nothing if it does
/// not, or only on an edge.
std::optional<double> height_on(const Corners& t, double x, double y) {
  const double area = (t[1] - t[0]).x() * (t[2] - t[0]).y() - (t[1] - t[0]).y() * (t[2] - t[0]).x();
  if (std::fabs(area) < 1e-12) return std::nullopt;
  const double u = ((x - t[0].x()) * (t[2] - t[0]).y() - (y - t[0].y()) * (t[2] - t[0]).x()) / area;
  const double v = ((t[1] - t[0]).x() * (y - t[0].y()) - (t[1] - t[0]).y() * (x - t[0].x())) / area;
  if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
  return t[0].z() + u * (t[1] - t[0]).z() + v * (t[2] - t[0]).z();
}

double ground_at(const World& world, double x, double y) {
  double highest = -1e9;
  for (std::size_t i = 0; i < world.ground.size(); ++i) {
    if (const auto z = height_on(world.ground.corners(i), x, y)) highest = std::max(highest, *z);
  }
  return highest;
}

/// Whether triangle and box overlap, by separating axes (Akenine-Moeller, Journal of Graphics Tools 6(1), 2001).
bool overlap(Corners t, const Vector3d& low, const Vector3d& high) {
  const Vector3d centre = (low + high) / 2, half = (high - low) / 2;
  for (Vector3d& corner : t) corner -= centre;
  const std::array<Vector3d, 3> edges = {t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  std::vector<Vector3d> axes = {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ(), edges[0].cross(edges[1])};
  for (const Vector3d& edge : edges) {
    for (int axis = 0; axis < 3; ++axis) axes.push_back(edge.cross(Vector3d::Unit(axis)));
  }
  return std::all_of(axes.begin(), axes.end(), [&](const Vector3d& axis) {
    const double reach = half.dot(axis.cwiseAbs());
    const double a = axis.dot(t[0]), b = axis.dot(t[1]), c = axis.dot(t[2]);
    return std::min({a, b, c}) <= reach && std::max({a, b, c}) >= -reach;
  });
}

/// Surfaces over the point, counted out of a closed body or into one: more than 0 is inside.
int inside_at(const World& world, const Vector3d& p) {
  int inside = 0;
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    if (!world.objects.surface(i).solid) continue;
    const Corners t = world.objects.corners(i);
    const auto z = height_on(t, p.x(), p.y());
    if (z && *z > p.z()) inside += (t[1] - t[0]).cross(t[2] - t[0]).z() > 0 ? 1 : -1;
  }
  return inside;
}

/// A cell's truth by the definition; nothing where rounding decides.
std::optional<CellTruth> by_definition(const World& world, const Robot::Body& body, int cx, int cy) {
  const double r = 0.01, x = (cx + 0.5) * r, y = (cy + 0.5) * r, ground = ground_at(world, x, y);
  const Vector3d low(cx * r, cy * r, ground + body.climbable_step_m),
      high((cx + 1) * r, (cy + 1) * r, ground + body.height_m);
  bool surely = false, perhaps = false;
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    const Corners t = world.objects.corners(i);
    perhaps |= overlap(t, low.array() - 1e-5, high.array() + 1e-5);
    surely |= overlap(t, low.array() + 1e-5, high.array() - 1e-5);
  }
  if (inside_at(world, {x, y, low.z()}) > 0) surely = perhaps = true;
  if (surely != perhaps) return std::nullopt;
  if (surely) return CellTruth::occupied;
  double up = 0, down = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const double step = ground_at(world, x + dx * r, y + dy * r) - ground;
      up = std::max(up, step);
      down = std::max(down, -step);
    }
  }
  if (up > body.climbable_step_m) return CellTruth::occupied;
  return down > kDropOff_m ? CellTruth::drop_off : CellTruth::free;
}

class TruthGridOf : public testing::TestWithParam<const char*> {};

TEST_P(TruthGridOf, IsWhatTheDefinitionSays) {
  const World world = make_world(GetParam(), 21);
  const Robot robot;
  Random random(5);
  std::array<int, 4> seen{};
  for (int patch = 0; patch < 40; ++patch) {
    const double x = between(random, world.extent.low.x() + 2, world.extent.high.x() - 2);
    const double y = between(random, world.extent.low.y() + 2, world.extent.high.y() - 2);
    const TruthGrid grid = make_truth(world, robot.body, 0.01, Rectangle{{x, y}, {x + 0.6, y + 0.6}});
    // Cells at random, and those where the state changes.
    for (int i = 0; i < 250; ++i) {
      const Cell cell{grid.low.x + static_cast<int>(random.below(60)), grid.low.y + static_cast<int>(random.below(60))};
      const CellTruth here = grid.at(cell);
      const bool edge = here != grid.at(Cell{cell.x + 1, cell.y}) || here != grid.at(Cell{cell.x, cell.y + 1});
      if (!edge && i % 200 != 0) continue;
      const auto expected = by_definition(world, robot.body, cell.x, cell.y);
      if (!expected) continue;
      ASSERT_EQ(here, *expected) << GetParam() << " cell " << cell.x << " " << cell.y;
      ++seen[static_cast<std::size_t>(here)];
    }
  }
  EXPECT_GT(seen[1], 50);
  EXPECT_GT(seen[2], 8);
}

INSTANTIATE_TEST_SUITE_P(Worlds, TruthGridOf, testing::Values("rubble", "kerbs", "trench", "car_park"));

TEST(Truth, ATrenchIsADropOnBothSides) {
  World world;
  world.extent = {{-2, -2}, {2, 2}};
  GroundPlan plan;
  plan.extent = world.extent;
  plan.levels = {{{{-0.303, -2}, {0.503, 2}}, -0.8, {0, 0}, true, Material::soil}};
  world.ground = plan.mesh();
  const TruthGrid grid = make_truth(world, Robot{}.body);
  EXPECT_EQ(grid.at(-0.305, 0.5), CellTruth::drop_off);
  EXPECT_EQ(grid.at(0.505, 0.5), CellTruth::drop_off);
  EXPECT_EQ(grid.at(-0.315, 0.5), CellTruth::free);
  EXPECT_EQ(grid.at(-0.295, 0.5), CellTruth::occupied) << "the trench's wall, from within";
  EXPECT_EQ(grid.at(0.0, 0.5), CellTruth::free);
  EXPECT_EQ(grid.at(2.5, 0.0), CellTruth::unknown);
}

TEST(Truth, KerbsOf5And12Centimetres) {
  World world;
  world.extent = {{-2, -2}, {2, 2}};
  GroundPlan plan;
  plan.extent = world.extent;
  plan.levels = {{{{-1, -1}, {-0.5, 1}}, 0.05, {0, 0}, true, Material::paving},
                 {{{0.5, -1}, {1, 1}}, 0.12, {0, 0}, true, Material::paving},
                 {{{-1, 1.2}, {1, 1.5}}, 0.015, {0, 0}, true, Material::paving}};
  world.ground = plan.mesh();
  const TruthGrid grid = make_truth(world, Robot{}.body);
  EXPECT_EQ(grid.at(-0.495, 0.0), CellTruth::occupied);
  EXPECT_EQ(grid.at(-0.505, 0.0), CellTruth::free) << "one can fall 5 cm";
  EXPECT_EQ(grid.at(0.495, 0.0), CellTruth::occupied);
  EXPECT_EQ(grid.at(0.505, 0.0), CellTruth::drop_off);
  EXPECT_EQ(grid.at(0.0, 1.195), CellTruth::free) << "a step of 1.5 cm can be climbed";
}

TEST(Truth, EveryNumberOfThreadsGivesTheSameCells) {
  const World world = make_world("rubble", 2);
  std::vector<TruthGrid> grids;
  for (const int threads : {1, 3}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    grids.push_back(make_truth(world, Robot{}.body, 0.04));
  }
  EXPECT_EQ(grids[0].cells, grids[1].cells);
}

}  // namespace
}  // namespace scanway::simulator::test
