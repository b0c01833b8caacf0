#include "modules/mapper/core/ground/soft_ground.h"

#include <cmath>

#include <gtest/gtest.h>

#include "common/random/random.h"

namespace scanway {
namespace {

constexpr double kHeight = 0.55;  // of the sensor above the ground
constexpr double kNoise = 0.01;

/// A lawn (x > 0) beside paving, seen from (0, 0, kHeight): beams that end on z = 0 with the range's noise, and on the
/// lawn with its relief, too. Brightness falls with range and angle as a Lambertian surface's does.
MapPoints lawn_beside_paving(double lawn_brightness, double lawn_relief, std::uint64_t seed) {
  Random random(seed);
  MapPoints points;
  points.origin = {0.0, 0.0, kHeight};
  for (double elevation = -1.2; elevation < -0.08; elevation += 0.003) {
    for (double heading = -3.14; heading < 3.14; heading += 0.004) {
      const Eigen::Vector3d beam(std::cos(elevation) * std::cos(heading), std::cos(elevation) * std::sin(heading),
                                 std::sin(elevation));
      const double range = kHeight / -beam.z();
      const bool lawn = beam.x() > 0;
      const double noise = kNoise * random.normal() + (lawn ? lawn_relief * random.normal() : 0.0);
      points.points.push_back((points.origin + (range + noise) * beam).cast<float>());
      points.intensity.push_back(
          static_cast<float>(100.0 * (lawn ? lawn_brightness : 1.0) * std::sqrt(-beam.z()) + 2.0 * random.normal()));
    }
  }
  return points;
}

GroundSurface ground_of_lawn(const MapPoints& points) { return {points, *find_ground_plane(points, {}), {}}; }

TEST(GroundPatches, MeasureTheNoiseAlongTheBeamHoweverFlatItIs) {
  const MapPoints points = lawn_beside_paving(1.2, 0.012, 1);
  const GroundPatches patches(points, ground_of_lawn(points));
  int judged = 0;
  for (const auto& [place, patch] : patches.all()) {
    if (patch.points < 100 || place.x == -1 || place.x == 0) continue;
    ++judged;
    const double true_noise = place.x > 0 ? std::sqrt(kNoise * kNoise + 0.012 * 0.012) : kNoise;
    EXPECT_NEAR(patch.roughness_m, true_noise, 0.3 * true_noise) << place.x << " " << place.y;
    EXPECT_NEAR(patch.cosine, kHeight / patch.range_m, 0.03);
  }
  EXPECT_GT(judged, 100);
}

TEST(GroundPatches, WithoutIntensitiesThereAreNone) {
  MapPoints points = lawn_beside_paving(1.2, 0.012, 1);
  points.intensity.clear();
  EXPECT_TRUE(GroundPatches(points, ground_of_lawn(points)).all().empty());
  EXPECT_TRUE(GroundPatches({}, ground_of_lawn(lawn_beside_paving(1.0, 0.0, 2))).all().empty());
}

/// Weights that know this test's brightness: log intensity over what paving has, and roughness.
SoftGroundModel of_this_scene() {
  SoftGroundModel model;
  model.weights = {-40.0 * std::log(110.0), 40.0, 0.0, -20.0, 0.0, 4.0, 0.0};
  return model;
}

TEST(SoftGround, IsTheLawnAndNotThePaving) {
  const MapPoints points = lawn_beside_paving(1.25, 0.012, 3);
  const SoftGround soft(GroundPatches(points, ground_of_lawn(points)), kNoise, of_this_scene());
  int lawn = 0, lawn_found = 0, paving = 0, paving_soft = 0;
  for (const auto& [place, softness] : soft.all()) {
    if (place.x == -1 || place.x == 0) continue;  // the border runs between them
    (place.x > 0 ? lawn : paving) += 1;
    if (softness == Softness::soft) (place.x > 0 ? lawn_found : paving_soft) += 1;
  }
  EXPECT_GT(lawn, 100);
  EXPECT_GT(paving, 100);
  EXPECT_GE(lawn_found, lawn * 95 / 100);
  EXPECT_LE(paving_soft, paving / 100);
}

TEST(SoftGround, IsUnknownWhereNeitherIsSure) {
  const MapPoints points = lawn_beside_paving(1.25, 0.012, 4);
  const SoftGround soft(GroundPatches(points, ground_of_lawn(points)), kNoise, {.weights = {}});
  for (const auto& [place, softness] : soft.all()) EXPECT_EQ(softness, Softness::unknown);
  EXPECT_EQ(soft.at(1000.0, 0.0), Softness::unknown);
}

}  // namespace
}  // namespace scanway
