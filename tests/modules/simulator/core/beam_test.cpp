#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "modules/simulator/core/laser/beam_random.h"
#include "tests/modules/simulator/core/test_worlds.h"

namespace scanway::simulator::test {
namespace {

using Eigen::Vector3d;

/// A wall at x = 4, and `gap` behind it another one; the first ends at y = 0. What beams along the edge's level read.
std::vector<double> readings_across_edge(double gap, Material material = Material::plaster) {
  Mesh mesh;
  add_block(mesh, {4, -20, -20}, {4.01, 0, 20}, {material, Label::building});
  add_block(mesh, {4 + gap, -20, -20}, {5 + gap, 20, 20}, {material, Label::building});
  const RayCaster world(std::array<const Mesh*, 1>{&mesh}), nobody(std::span<const Mesh*const>{});
  Robot::Laser laser;
  laser.range_sigma_m = 0.0;
  const People people;
  const BeamModel model(laser, world, nobody, people);
  std::vector<double> ranges;
  for (int i = -100; i <= 100; ++i) {  // Angles in steps of 0.1 mrad; the footprint at 4 m is 19 mm wide.
    const double angle = i * 1e-4;
    const BeamReading reading = model.read(Pose::Identity(), angle, 0.0, beam_random(1, 0, i));
    if (reading.range_count > 0) ranges.push_back(reading.range_count * model.range_scale_m());
  }
  return ranges;
}

TEST(Beam, AtAnEdgeSurfacesThatAreCloseMix) {
  const std::vector<double> ranges = readings_across_edge(0.3);
  ASSERT_EQ(ranges.size(), 201U);
  const auto mixed = std::count_if(ranges.begin(), ranges.end(), [](double r) { return r > 4.02 && r < 4.28; });
  EXPECT_GE(mixed, 15);  // Those whose footprint of 4.7 mrad holds the edge, at least half of it.
  EXPECT_LE(mixed, 48);
  EXPECT_EQ(std::count_if(ranges.begin(), ranges.end(), [](double r) { return r < 3.99 || r > 4.31; }), 0);
}

TEST(Beam, AtAnEdgeOfSurfacesThatAreFarApartTheNearOneAnswers) {
  for (const double range : readings_across_edge(2.0)) {
    EXPECT_TRUE((range > 3.99 && range < 4.01) || (range > 5.99 && range < 6.01)) << range;
  }
}

TEST(Beam, TooLittleLightIsNoReturn) {
  EXPECT_EQ(readings_across_edge(60.0, Material::dark_paint).back(), 4.0) << "a dark wall at 64 m is not seen";
  EXPECT_NEAR(readings_across_edge(30.0, Material::plaster).back(), 34.0, 0.02);
}

TEST(Beam, RssiSaysMaterialAndIncidence) {
  const auto rssi = [](Material material, double angle) {
    Mesh mesh;
    add_block(mesh, {4, -20, -20}, {5, 20, 20}, {material, Label::building});
    const RayCaster world(std::array<const Mesh*, 1>{&mesh}), nobody(std::span<const Mesh*const>{});
    const Robot::Laser laser;
    double sum = 0;
    for (int i = 0; i < 50; ++i) {
      sum +=
          BeamModel(laser, world, nobody, People()).read(Pose::Identity(), angle, 0.0, beam_random(1, i, 0)).rssi_count;
    }
    return sum / 50;
  };
  EXPECT_GT(rssi(Material::plaster, 0), rssi(Material::asphalt, 0) + 20);
  EXPECT_GT(rssi(Material::asphalt, 0), rssi(Material::dark_paint, 0) + 10);
  EXPECT_GT(rssi(Material::plaster, 0), rssi(Material::plaster, 1.2) + 15);
  EXPECT_EQ(rssi(Material::reflector, 0), 255);
  EXPECT_EQ(rssi(Material::glass, 0.8), 0) << "glass sends the light elsewhere";
}

TEST(Beam, RandomNumbersOfNeighboursHaveNothingInCommon) {
  std::set<std::uint64_t> seen;
  double products = 0;
  for (int line = -2; line < 200; ++line) {
    for (int beam = -1; beam < 200; ++beam) {
      seen.insert(beam_random(9, line, beam).next());
      products += beam_random(9, line, beam).normal() * beam_random(9, line, beam + 1).normal();
    }
  }
  EXPECT_EQ(seen.size(), 202U * 201U);
  EXPECT_NEAR(products / static_cast<double>(seen.size()), 0.0, 0.025);
}

TEST(RayCaster, ARayThatIsNoneMeetsNothing) {
  const RayCaster caster = caster_of(Room{}.world());
  const Vector3d origin(0, 0, 1), ahead = Vector3d::UnitX(), none(NAN, 0, 0);
  EXPECT_FALSE(caster.cast(origin, none, 80.0).has_value());
  EXPECT_FALSE(caster.cast(none, ahead, 80.0).has_value());
  const auto hits = caster.cast(origin, RayCaster::Four{ahead, none, ahead, ahead}, 80.0);
  EXPECT_TRUE(hits[0] && !hits[1] && hits[2] && hits[3]) << "the others are as ever";
}

}  // namespace
}  // namespace scanway::simulator::test
