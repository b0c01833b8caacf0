#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "common/messages/bad_message.h"
#include "common/messages/codec.h"
#include "common/messages/cost_map_message.h"
#include "common/messages/goal_message.h"
#include "common/messages/imu_message.h"
#include "common/messages/params_message.h"
#include "common/messages/pose_message.h"
#include "common/messages/rigid.h"
#include "common/messages/sweep_message.h"
#include "common/random/random.h"

namespace scanway {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class T>
T over_the_wire(const T& message) {
  return decode<T>(encode(message));
}

Eigen::Quaterniond random_rotation(Random& random) {
  return Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
}

Sweep random_sweep(Random& random, std::size_t n) {
  Sweep sweep;
  sweep.name = "scan " + std::to_string(n);
  sweep.utime = static_cast<Utime>(random.next());
  for (std::size_t i = 0; i < n; ++i) {
    sweep.cloud.points.emplace_back(static_cast<float>(random.normal()), 0.0F, static_cast<float>(random.normal()));
  }
  if (random.below(2) == 0) sweep.cloud.intensity.assign(n, 3.5F);
  if (random.below(2) == 0) sweep.time_offset_us.assign(n, -7);
  sweep.origin = {random.normal(), random.normal(), random.normal()};
  if (random.below(2) == 0) sweep.sensor_height_m = random.uniform();
  return sweep;
}

TEST(SweepMessage, RoundTrips) {
  Random random(1);
  for (std::size_t n : {0, 1, 2, 100, 5000}) {
    const Sweep sweep = random_sweep(random, n);
    const Sweep back = to_sweep(over_the_wire(to_message(sweep)));
    EXPECT_EQ(back.name, sweep.name);
    EXPECT_EQ(back.utime, sweep.utime);
    EXPECT_EQ(back.cloud.points, sweep.cloud.points);
    EXPECT_EQ(back.cloud.intensity, sweep.cloud.intensity);
    EXPECT_EQ(back.time_offset_us, sweep.time_offset_us);
    EXPECT_EQ(back.origin, sweep.origin);
    EXPECT_EQ(back.sensor_height_m, sweep.sensor_height_m);
    EXPECT_FALSE(back.R_world_sweep);
  }
}

TEST(SweepMessage, RefusesWhatContradictsItself) {
  Random random(2);
  sweep_t good = to_message(random_sweep(random, 5));
  EXPECT_NO_THROW(to_sweep(good));
  sweep_t bad = good;
  bad.nintensities = 4;
  EXPECT_THROW(to_sweep(bad), BadMessage);
  bad = good;
  bad.noffsets = 6;
  EXPECT_THROW(to_sweep(bad), BadMessage);
  bad = good;
  bad.origin[1] = kNan;
  EXPECT_THROW(to_sweep(bad), BadMessage);
  bad = good;
  bad.sensor_height_m = kInfinity;
  EXPECT_THROW(to_sweep(bad), BadMessage);
}

Sweep with_fans(Sweep sweep, Random& random) {
  for (int i = 0; i < 30; ++i) {
    const double a = 6.28 * random.uniform(), z = 2 * random.uniform() - 1, r = std::sqrt(1 - z * z);
    const double b = a + 0.1 * random.uniform();
    sweep.no_return.push_back({to_direction({r * std::cos(a), r * std::sin(a), z}),
                               to_direction({r * std::cos(b), r * std::sin(b), z}),
                               static_cast<std::int16_t>(1 + random.below(60))});
  }
  return sweep;
}

TEST(SweepObject, IsTheSameAsEverWithoutBeamsThatGaveNoReturn) {
  Random random(4);
  const Sweep sweep = random_sweep(random, 50);
  EXPECT_EQ(encode(sweep), encode(to_message(sweep)));
  EXPECT_EQ(decode<Sweep>(encode(to_message(sweep))).cloud.points, sweep.cloud.points);
  EXPECT_TRUE(decode<Sweep>(encode(sweep)).no_return.empty());
}

TEST(SweepObject, CarriesTheBeamsThatGaveNoReturn) {
  Random random(5);
  for (const std::size_t points : {0, 40}) {
    const Sweep sweep = with_fans(random_sweep(random, points), random);
    const auto bytes = encode(sweep);
    const Sweep back = decode<Sweep>(bytes);
    EXPECT_EQ(back.no_return, sweep.no_return);
    EXPECT_EQ(back.cloud.points, sweep.cloud.points);
    EXPECT_EQ(back.utime, sweep.utime);
    EXPECT_EQ(encode(back), bytes);
  }
}

TEST(SweepObject, RefusesBeamsWithoutDirection) {
  Random random(6);
  const Sweep good = with_fans(random_sweep(random, 5), random);
  const auto refused = [&](const auto& spoil) {
    Sweep sweep = good;
    spoil(sweep.no_return[7]);
    EXPECT_THROW(decode<Sweep>(encode(sweep)), BadMessage);
  };
  refused([](BeamFan& fan) { fan.beams = 0; });
  refused([](BeamFan& fan) { fan.beams = -5; });
  refused([](BeamFan& fan) { fan.first = {0, 0, 0}; });
  refused([](BeamFan& fan) { fan.last = {32767, 32767, 0}; });
  refused([](BeamFan& fan) {
    fan = {to_direction({1, 0, 0}), to_direction({0, 1, 0}), 9};  // A quarter of a turn.
  });
}

TEST(ImuMessage, CarriesTheQuaternionWithWFirst) {
  const Eigen::Quaterniond R(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
  const auto message = imu_message(12, R);
  EXPECT_DOUBLE_EQ(message.quat[0], std::cos(0.25));
  EXPECT_DOUBLE_EQ(message.quat[3], std::sin(0.25));
  EXPECT_TRUE(std::isnan(message.accel[2]));
  EXPECT_TRUE(orientation_of(over_the_wire(message)).isApprox(R, 1e-15));
}

TEST(ImuMessage, RefusesWhatIsNoRotation) {
  auto message = imu_message(12, Eigen::Quaterniond::Identity());
  for (const double bad : {0.0, 0.9, 1.1, kNan, kInfinity}) {
    message.quat[0] = bad;
    EXPECT_THROW(orientation_of(message), BadMessage) << bad;
  }
}

TEST(PoseMessage, RoundTrips) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    Pose X = Pose::Identity();
    X.linear() = random_rotation(random).toRotationMatrix();
    X.translation() = Eigen::Vector3d(random.normal(), random.normal(), random.normal()) * 100;
    EXPECT_TRUE(pose_of(over_the_wire(pose_message(5, X))).isApprox(X, 1e-14));
    double rows[16];
    put_rows(X, rows);
    EXPECT_EQ(rows[3], X.translation().x());
    EXPECT_EQ(get_rows(rows).matrix(), X.matrix());
    rows[15] = 2;
    EXPECT_THROW(get_rows(rows), BadMessage);
  }
  auto message = pose_message(5, Pose::Identity());
  message.pos[0] = kInfinity;
  EXPECT_THROW(pose_of(message), BadMessage);
}

TEST(GoalMessage, RoundTrips) {
  EXPECT_EQ(goal_of(over_the_wire(goal_message(1, {3.5, -2.25}))), Eigen::Vector2d(3.5, -2.25));
  EXPECT_THROW(goal_of(goal_message(1, {kNan, 0})), BadMessage);
}

TEST(ParamsMessage, KnowsItsSchema) {
  auto message = over_the_wire(params_message(1, "name: era_mobi\n"));
  EXPECT_EQ(robot_yaml_of(message), "name: era_mobi\n");
  for (const int schema : {-1, 0, kParamsSchema + 1}) {
    message.schema_version = schema;
    EXPECT_THROW(robot_yaml_of(message), BadMessage);
  }
}

TEST(CostMapMessage, RoundTrips) {
  Random random(4);
  CostTile tile;
  for (auto& state : tile.state) state = static_cast<CellState>(random.below(3));
  for (auto& cost : tile.cost) cost = random.below(2) == 0 ? kCostLethal : static_cast<std::uint32_t>(random.next());
  auto message = over_the_wire(to_message({-3, 12}, tile, 6, 7));
  EXPECT_EQ(message.tile_x, -3);
  EXPECT_EQ(message.tile_y, 12);
  EXPECT_EQ(to_cost_tile(message), tile);
  message.cell_state[77] = 3;
  EXPECT_THROW(to_cost_tile(message), BadMessage);
  EXPECT_EQ(tile_key({-3, 12}), "-3,12");
  message = to_message({0, 0}, tile, 6, 7);
  message.side_cells = 64;
  EXPECT_THROW(to_cost_tile(message), BadMessage);
}

TEST(CostMapMessage, ClosesAVersionByTheContentOfItsTiles) {
  const CostMap map;
  const std::vector<cost_tile_entry_t> tiles = {{1, 0, 3, 111}, {0, 5, 2, 222}, {0, -1, 3, 333}};
  auto index = over_the_wire(close_map(map, 3, 50, tiles));
  EXPECT_NO_THROW(check_index(index));
  EXPECT_EQ(index.tiles[0].tile_digest, 333);
  EXPECT_EQ(index.map_digest, close_map(map, 3, 60, {tiles[2], tiles[0], tiles[1]}).map_digest);
  EXPECT_NE(index.map_digest, close_map(map, 3, 50, {tiles[2], tiles[0]}).map_digest);
  auto bad = index;
  bad.tiles[1].tile_digest ^= 1;
  EXPECT_THROW(check_index(bad), BadMessage);
  bad = index;
  std::swap(bad.tiles[0], bad.tiles[1]);
  EXPECT_THROW(check_index(bad), BadMessage);
  bad = close_map(map, 3, 50, {tiles[0], tiles[0]});
  EXPECT_THROW(check_index(bad), BadMessage);
}

}  // namespace
}  // namespace scanway
