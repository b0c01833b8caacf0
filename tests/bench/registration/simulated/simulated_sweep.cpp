#include "tests/bench/registration/simulated/simulated_sweep.h"

#include <cmath>
#include <optional>

#include "common/files/input_error.h"
#include "common/math/repeatable.h"
#include "common/random/random.h"

namespace scanway::bench {
namespace {

using namespace simulator;

constexpr double kStep = 0.5;        // metres between the places on the route that are tried
constexpr double kRouteSpan = 90.0;  // metres of the route on which they lie
constexpr int kStarts = 200;         // first places that are tried

const Robot& robot() {
  static const Robot kRobot = simulated_robot();
  return kRobot;
}

Stand turned_stand(const World& world, Place place, Random& random) {
  place.heading += 2.0 * repeatable::kPi * random.uniform();
  return stand_at(world, robot(), place);
}

/// The first place of the route, from `first` on, that lies so far away.
std::optional<Place> place_at_distance(const std::vector<Place>& places, std::size_t first, double distance_m) {
  for (std::size_t i = first + 1; i < places.size(); ++i) {
    const double d = std::hypot(places[i].x - places[first].x, places[i].y - places[first].y);
    if (std::fabs(d - distance_m) <= kStep) return places[i];
  }
  return std::nullopt;
}

}  // namespace

SimulatedCloud simulate_cloud(const RayCaster& caster, const Pose& X_world_base, int thin, std::uint64_t seed,
                              double slower) {
  Robot turning = robot();
  turning.pan.speed_rad_s /= slower;
  SweepConfig config;
  config.seed = seed;
  config.thin = thin;
  Sweep sweep = points_of(simulate_lines(caster, turning, X_world_base, config), turning).sweep;
  return {std::move(sweep.cloud), sweep.origin, X_world_base, Tracker(robot().tracker, X_world_base, seed).mean()};
}

OrientationPrior tracker_prior(const Eigen::Quaterniond& source, const Eigen::Quaterniond& target) {
  OrientationPrior prior;
  prior.R_target_source = (target.conjugate() * source).toRotationMatrix();
  prior.heading_sigma = std::sqrt(2.0) * robot().tracker.heading_sigma;
  prior.tilt_sigma = std::sqrt(2.0) * robot().tracker.tilt_sigma;
  return prior;
}

RegistrationConfig simulated_limits(std::uint64_t seed) {
  return {robot().laser.min_range_m, robot().laser.max_range_m, seed};
}

SimulatedPair simulate_pair(const std::string& world_name, std::uint64_t seed, double distance_m, int thin,
                            double slower) {
  const World world = make_world(world_name, seed);
  const auto places = places_on_route(world, static_cast<int>(kRouteSpan / kStep), kStep, 1.0);
  Random random(seed * 7919 + 17);
  for (int tries = 0; tries < kStarts; ++tries) {
    const std::size_t first = random.below(places.size());
    const std::optional<Place> second = place_at_distance(places, first, distance_m);
    if (!second) continue;
    const Stand target = turned_stand(world, places[first], random), source = turned_stand(world, *second, random);
    if (!source.problem.empty() || !target.problem.empty()) continue;
    const RayCaster caster = caster_of(world);
    return {simulate_cloud(caster, source.X_world_base, thin, seed * 2, slower),
            simulate_cloud(caster, target.X_world_base, thin, seed * 2 + 1, slower)};
  }
  throw InputError("The route of " + world_name + " has no two places so far apart");
}

}  // namespace scanway::bench
