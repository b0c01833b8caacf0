#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules/simulator/core/test_worlds.h"

namespace scanway::simulator::test {
namespace {

struct PeopleSweep {
  explicit PeopleSweep(int people) {
    SweepConfig config;
    config.seed = 4;
    config.people = people;
    raw = simulate_lines(caster, robot, stand.X_world_base, config);
  }
  World world = make_world("yard", 2);
  RayCaster caster = caster_of(world);
  Robot robot = quick_robot();
  Stand stand = stand_at(world, robot, places_on_route(world, 3).at(1));
  RawSweep raw{ScanPattern(robot, 0, 0), 1, 0, 0, 0.001, {}};
};

TEST(People, AreMetWhereTheyAreAtTheBeamsOwnTime) {
  const PeopleSweep sweep(4);
  const People people(sweep.caster, sweep.stand.X_world_base.translation(), 4, 4);
  ASSERT_EQ(people.size(), 4U);
  const LabelledSweep points = points_of(sweep.raw, sweep.robot);
  int met = 0, walked_through = 0;
  for (std::size_t i = 0; i < points.labels.size(); ++i) {
    if (points.labels[i] != Label::person) continue;
    const Eigen::Vector3d p = sweep.stand.X_world_base * points.sweep.cloud.points[i].cast<double>();
    const auto after_us =
        static_cast<double>(points.sweep.utime + points.sweep.time_offset_us[i] - sweep.raw.pattern.start());
    double nearest = 1e9, before = 1e9;
    for (std::size_t k = 0; k < people.size(); ++k) {
      const auto aside = [&](double time_us) {
        return Eigen::Vector2d((people.X_world_person(k, time_us).inverse() * p).head<2>()).norm();
      };
      nearest = std::min(nearest, aside(after_us));
      before = std::min(before, aside(after_us - 3e6));
    }
    ASSERT_LT(nearest, 0.6);  // Its girth, and what mixes at its edge.
    ++met;
    walked_through += before > 1.0 ? 1 : 0;
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(walked_through, met / 3) << "not where they were three seconds before";
}

TEST(People, HideNothingButWhatIsBehindThem) {
  const PeopleSweep with(4), without(0);
  int hidden = 0, changed = 0;
  for (std::size_t i = 0; i < with.raw.readings.size(); ++i) {
    const BeamReading &a = with.raw.readings[i], &b = without.raw.readings[i];
    EXPECT_NE(b.label, Label::person);
    if (a == b) continue;
    (a.label == Label::person ? hidden : changed) += 1;
  }
  EXPECT_GT(hidden, 100);
  EXPECT_LT(changed, hidden);  // Beams half on a person.
}

TEST(People, WalkOnTheGroundToAndFroAndThroughNothing) {
  const World world = make_world("yard", 5);
  const RayCaster caster = caster_of(world);
  const Stand stand = stand_at(world, simulated_robot(), places_on_route(world, 3).at(1));
  const Eigen::Vector3d place = stand.X_world_base.translation();
  const People people(caster, place, 6, 9), again(caster, place, 6, 9), others(caster, place, 6, 10);
  ASSERT_GE(people.size(), 4U);
  for (std::size_t i = 0; i < people.size(); ++i) {
    for (double s = 0; s < 120; s += 0.5) {
      const Pose now = people.X_world_person(i, s * 1e6), next = people.X_world_person(i, (s + 0.1) * 1e6);
      ASSERT_EQ(now.matrix(), again.X_world_person(i, s * 1e6).matrix());
      const double pace = (next.translation() - now.translation()).norm() / 0.1;
      ASSERT_LT(pace, 1.7);
      ASSERT_GT((now.translation() - place).head<2>().norm(), 0.99);
      const auto ground = caster.cast(now.translation() + Eigen::Vector3d(0, 0, 1), -Eigen::Vector3d::UnitZ(), 3.0);
      ASSERT_TRUE(ground && ground->surface.label == Label::ground);
      ASSERT_NEAR(ground->range_m, 1.0, 0.1);
    }
  }
  EXPECT_NE(people.X_world_person(0, 0.0).matrix(), others.X_world_person(0, 0.0).matrix());
}

TEST(People, WalkNowhereWhereThereIsNoRoom) {
  const Room closet{{-0.8, -0.8, 0.0}, {0.8, 0.8, 2.5}};
  const RayCaster caster = caster_of(closet.world());
  EXPECT_TRUE(People(caster, {0, 0, 0}, 3, 1).empty());
}

}  // namespace
}  // namespace scanway::simulator::test
