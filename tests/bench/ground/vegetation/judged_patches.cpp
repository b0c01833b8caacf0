#include "tests/bench/ground/vegetation/judged_patches.h"

#include <optional>

#include "modules/mapper/core/costmap/look.h"
#include "modules/simulator/core/ray/ray_caster.h"
#include "modules/simulator/core/simulator.h"

namespace scanway::bench {
namespace {

using namespace simulator;

constexpr double kLeastLevel = 2.0;  // square metres, as the mapper has it

/// Of the ground at (x, y), world frame.
std::optional<Material> material_at(const RayCaster& ground, double x, double y) {
  const auto hit = ground.cast({x, y, 50.0}, {0.0, 0.0, -1.0}, 100.0);
  return hit ? std::optional(hit->surface.material) : std::nullopt;
}

/// What all of a patch is made of; nothing where two materials meet. The map is the world.
std::optional<Material> material_of(const RayCaster& ground, Cell place) {
  std::optional<Material> material;
  for (const double x : {0.01, 0.5, 0.99}) {
    for (const double y : {0.01, 0.5, 0.99}) {
      const auto here = material_at(ground, (place.x + x) * GroundPatches::kSide, (place.y + y) * GroundPatches::kSide);
      if (!here || (material && *here != *material)) return std::nullopt;
      material = here;
    }
  }
  return material;
}

void add_patches(const MapPoints& points, const Robot& robot, const RayCaster& truth,
                 std::vector<JudgedPatch>& judged) {
  const GroundReport ground = find_ground(points, std::nullopt, robot, 1);
  if (!ground.plane) return;
  const GroundSurface surface(
      points, *ground.plane,
      {robot.body.climbable_step_m, robot.body.climbable_slope, robot.laser.range_sigma_m, kCostMapReach, kLeastLevel});
  const GroundPatches patches(points, surface);
  const SoftGround soft(patches, robot.laser.range_sigma_m);
  for (const auto& [place, patch] : patches.all()) {
    const auto material = material_of(truth, place);
    if (material) judged.push_back({patch, soft.all().at(place), *material});
  }
}

}  // namespace

std::vector<JudgedPatch> patches_of_world(const std::string& name, std::uint64_t seed, int sweeps, int thin,
                                          double brightness) {
  const World world = make_world(name, seed);
  const Mesh* const ground = &world.ground;
  const RayCaster truth(std::span(&ground, 1));
  const Robot robot = simulated_robot();
  SweepConfig config;
  config.thin = thin;
  config.seed = seed * 100;
  std::vector<JudgedPatch> judged;
  for (const Place& place : places_on_route(world, sweeps, 0.0, 1.0)) {
    ++config.seed;
    const SimulatedSweep taken = simulate_sweep(world, place, robot, config);
    MapPoints points = points_in_map(taken.sweep, taken.X_world_base, robot.laser.min_range_m, robot.laser.max_range_m);
    for (float& intensity : points.intensity) intensity *= static_cast<float>(brightness);
    add_patches(points, robot, truth, judged);
  }
  return judged;
}

}  // namespace scanway::bench
