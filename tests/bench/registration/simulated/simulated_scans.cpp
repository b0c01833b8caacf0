#include "tests/bench/registration/simulated/simulated_scans.h"

#include <algorithm>

#include "common/math/repeatable.h"
#include "common/random/random.h"
#include "modules/mapper/core/registration/prepared_scan.h"
#include "tests/bench/registration/simulated/simulated_sweep.h"

namespace scanway::bench {
namespace {

using namespace simulator;

constexpr std::size_t kSamples = 4000;
constexpr int kTries = 50;  // a place, until the robot can stand there

/// Every n-th point, about kSamples of them.
std::vector<Eigen::Vector3f> some_points(const PointCloud& cloud) {
  std::vector<Eigen::Vector3f> some;
  const std::size_t stride = std::max<std::size_t>(1, cloud.size() / kSamples);
  for (std::size_t i = stride / 2; i < cloud.size(); i += stride) some.push_back(cloud.points[i]);
  return some;
}

Place random_place(const World& world, double start_m, double span_m, Random& random) {
  Place place = places_on_route(world, 1, 1.0, start_m + span_m * random.uniform()).at(0);
  place.heading += 2.0 * repeatable::kPi * random.uniform();
  return place;
}

void add_sweep(const RayCaster& caster, const World& world, const Stand& stand, const SimulatedPlan& plan,
               std::uint64_t seed, SimulatedScans& scans) {
  const SimulatedCloud sweep = simulate_cloud(caster, stand.X_world_base, plan.thin, seed);
  scans.scans.push_back(PreparedScan::make(sweep.cloud, sweep.origin, simulated_limits(world.seed)));
  scans.samples.push_back(some_points(sweep.cloud));
  scans.X_world_base.push_back(sweep.X_world_base);
  scans.R_tracker.push_back(sweep.R_tracker);
}

double one_way(const std::vector<Eigen::Vector3f>& points, const PreparedScan::Data& to, const Pose& T) {
  std::size_t near = 0;
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3d moved = T * p.cast<double>() - to.origin;
    near += to.fine.any_within(moved.cast<float>(), 0.3f) ? 1 : 0;
  }
  return static_cast<double>(near) / static_cast<double>(std::max<std::size_t>(1, points.size()));
}

}  // namespace

OrientationPrior SimulatedScans::prior(std::size_t source, std::size_t target) const {
  return tracker_prior(R_tracker[source], R_tracker[target]);
}

double SimulatedScans::overlap(std::size_t a, std::size_t b) const {
  const Pose T_ba = T_target_source(a, b);
  return std::min(one_way(samples[a], scans[b].data(), T_ba), one_way(samples[b], scans[a].data(), T_ba.inverse()));
}

SimulatedScans simulate_scans(const std::string& world_name, std::uint64_t seed, const SimulatedPlan& plan) {
  SimulatedScans scans{world_name, seed, {}, {}, {}, {}};
  const World world = make_world(world_name, seed);
  const RayCaster caster = caster_of(world);
  static const Robot kRobot = simulated_robot();
  Random random(seed * 7919 + 17);
  for (int tries = 0; static_cast<int>(scans.scans.size()) < plan.sweeps && tries < kTries * plan.sweeps; ++tries) {
    const Stand stand = stand_at(world, kRobot, random_place(world, 1.0, plan.span_m, random));
    if (!stand.problem.empty()) continue;
    add_sweep(caster, world, stand, plan, seed * 1000 + scans.scans.size(), scans);
  }
  return scans;
}

}  // namespace scanway::bench
