#pragma once

#include <string>

#include "modules/mapper/core/registration/registration.h"
#include "modules/simulator/core/simulator.h"

namespace scanway::bench {

/// A sweep of the simulator as a mapper gets it, and its truth.
struct SimulatedCloud {
  PointCloud cloud;  ///< In `base`.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Pose X_world_base = Pose::Identity();
  Eigen::Quaterniond R_tracker = Eigen::Quaterniond::Identity();
};

/// Only every thin-th line of the sweep, and of it every thin-th beam. `slower`: the pan turns so many times slower
/// than the robot's, for as many more lines.
SimulatedCloud simulate_cloud(const simulator::RayCaster& caster, const Pose& X_world_base, int thin,
                              std::uint64_t seed, double slower = 1.0);

/// What the robot's tracker says of a pair from its two readings.
OrientationPrior tracker_prior(const Eigen::Quaterniond& source, const Eigen::Quaterniond& target);
/// The range limits of the simulated robot's laser.
RegistrationConfig simulated_limits(std::uint64_t seed);

struct SimulatedPair {
  SimulatedCloud source, target;

  Pose T_target_source() const { return target.X_world_base.inverse() * source.X_world_base; }
  OrientationPrior prior() const { return tracker_prior(source.R_tracker, target.R_tracker); }
};

/// Two sweeps on the world's route, `distance_m` apart (to half a metre, as the crow flies), at any headings.
/// Throws InputError when the route has no two such places.
SimulatedPair simulate_pair(const std::string& world, std::uint64_t seed, double distance_m, int thin,
                            double slower = 1.0);

}  // namespace scanway::bench
