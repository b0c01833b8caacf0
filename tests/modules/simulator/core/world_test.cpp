#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "tests/modules/simulator/core/test_worlds.h"

namespace scanway::simulator::test {
namespace {

class EveryWorld : public testing::TestWithParam<std::string> {};

TEST_P(EveryWorld, CanBeDrivenAndScanned) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const World world = make_world(GetParam(), seed);
    const Robot robot = quick_robot();
    for (const Place& place : places_on_route(world, 8)) {
      const Stand stand = stand_at(world, robot, place);
      ASSERT_EQ(stand.problem, "") << "seed " << seed << " at " << place.x << "," << place.y;
      // It stands on the ground, upright but for what the ground makes of it.
      EXPECT_LT(rotation_angle(rotation_about_z(place.heading).transpose() * stand.X_world_base.linear()), radians(13));
    }
  }
  const World world = make_world(GetParam(), 7);
  const SimulatedSweep simulated = simulate_sweep(world, places_on_route(world, 3)[1], quick_robot(), 7);
  const std::size_t beams = 300 * 191, points = simulated.labels.size();
  EXPECT_GT(points, beams / 4);
  EXPECT_LT(points, beams * 9 / 10);
  const std::set<Label> labels(simulated.labels.begin(), simulated.labels.end());
  EXPECT_TRUE(labels.contains(Label::ground));
  EXPECT_FALSE(labels.contains(Label::nothing));
  EXPECT_FALSE(labels.contains(Label::robot));
  const bool open = GetParam() == "field";
  EXPECT_EQ(labels.size() == 1, open);
  const auto ground = std::count(simulated.labels.begin(), simulated.labels.end(), Label::ground);
  EXPECT_GT(ground, static_cast<std::ptrdiff_t>(points / 10));
}

TEST_P(EveryWorld, IsMadeByItsSeed) {
  const World one = make_world(GetParam(), 5), again = make_world(GetParam(), 5), other = make_world(GetParam(), 6);
  EXPECT_EQ(one.objects.vertices(), again.objects.vertices());
  EXPECT_EQ(one.ground.vertices(), again.ground.vertices());
  EXPECT_TRUE(one.objects.vertices() != other.objects.vertices() || one.ground.vertices() != other.ground.vertices());
}

TEST_P(EveryWorld, EndsAtItsExtent) {
  const World world = make_world(GetParam(), 5);
  const Stand stand = stand_at(world, Robot{}, {world.extent.high.x() + 3, 0, 0});
  EXPECT_NE(stand.problem.find("outside the world"), std::string::npos) << stand.problem;
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const WorldKind& kind : world_kinds()) all.emplace_back(kind.name);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Worlds, EveryWorld, testing::ValuesIn(names()), [](const auto& world) { return world.param; });

TEST(Worlds, NobodyStandsInAWall) {
  const World world = make_world("hall", 1);
  EXPECT_NE(stand_at(world, Robot{}, {-18, 5, 0}).problem.find("in a wall"), std::string::npos);  // A pillar.
  EXPECT_THROW(simulate_sweep(world, {-18, 5, 0}, quick_robot(), 1), std::invalid_argument);
  EXPECT_THROW(make_world("moon", 1), std::invalid_argument);
}

TEST(Worlds, TheSlopeHasTenDegrees) {
  const World world = make_world("slope", 1);
  const Stand stand = stand_at(world, Robot{}, {0, 0, 0});
  EXPECT_NEAR(rotation_angle(stand.X_world_base.linear()), radians(10), 1e-5);
  EXPECT_GT(stand.X_world_base.linear()(2, 0), 0.17) << "it looks uphill";
}

TEST(Worlds, ALoopOfPlacesComesRound) {
  const World world = make_world("street", 1);
  ASSERT_TRUE(world.route_is_loop);
  const std::vector<Place> places = places_on_route(world, 12);
  ASSERT_EQ(places.size(), 12U);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place &a = places[i], &b = places[(i + 1) % places.size()];
    EXPECT_LE(std::hypot(a.x - b.x, a.y - b.y), 12.0);
    EXPECT_GE(std::hypot(a.x - b.x, a.y - b.y), 6.0);
  }
}

}  // namespace
}  // namespace scanway::simulator::test
