#pragma once

#include <string>
#include <vector>

#include "modules/mapper/core/registration/registration.h"
#include "modules/simulator/core/simulator.h"

namespace scanway::bench {

/// Sweeps of one world, ready to be registered, with their true poses: n of them are n (n - 1) / 2 pairs.
struct SimulatedScans {
  std::string world;
  std::uint64_t seed = 0;
  std::vector<PreparedScan> scans;
  std::vector<std::vector<Eigen::Vector3f>>
      samples;  ///< Some points of each sweep, in its frame: what overlap is counted on.
  std::vector<Pose> X_world_base;
  std::vector<Eigen::Quaterniond> R_tracker;

  Pose T_target_source(std::size_t source, std::size_t target) const {
    return X_world_base[target].inverse() * X_world_base[source];
  }
  /// What the robot's tracker says of the pair, with the deviations of two readings.
  OrientationPrior prior(std::size_t source, std::size_t target) const;
  /// Share of the source's points with a target point within 0.3 m at the true pose, of the two directions the worse.
  double overlap(std::size_t a, std::size_t b) const;
};

struct SimulatedPlan {
  int sweeps = 12;
  double span_m = 45.0;  ///< Of the route on which the robot stops, at random places and headings.
  int thin = 4;          ///< Only every thin-th line, and of it every thin-th beam.
};

SimulatedScans simulate_scans(const std::string& world, std::uint64_t seed, const SimulatedPlan& plan);

}  // namespace scanway::bench
