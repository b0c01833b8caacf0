#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "modules/mapper/core/movement/movement.h"
#include "modules/simulator/core/simulator.h"

namespace scanway::testing {

/// What happens while the second sweep of a pair is taken.
struct Disturbance {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< Of the robot, in its own axes.
  double turn = 0.0;
  double after_s = 0.0;  ///< 0: it stands.
  int people = 0;
};

/// A world, and two places 6 m apart on its route. The first sweep is taken once.
class SimulatedPair {
 public:
  SimulatedPair(const std::string& world, std::uint64_t seed, int thin)
      : world_(simulator::make_world(world, seed)), caster_(simulator::caster_of(world_)), seed_(seed), thin_(thin) {
    const std::vector<simulator::Place> places = simulator::places_on_route(world_, 2, 6.0, 3.0);
    X_world_first_ = simulator::stand_at(world_, robot_, places[0]).X_world_base;
    X_world_second_ = simulator::stand_at(world_, robot_, places[1]).X_world_base;
    first_ = take(X_world_first_, 0, 2 * seed);
  }

  /// As the mapper sees it. Throws std::runtime_error where the two are not registered.
  Movement movement(const Disturbance& by) const {
    const Sweep second = disturbed(by);
    const PreparedScan source = prepared(second), target = prepared(first_);
    const OrientationPrior prior{(first_.R_world_sweep->conjugate() * *second.R_world_sweep).toRotationMatrix(), 0.1234,
                                 0.0123};
    const RegistrationResult found = register_scans(source, target, prior, config_);
    if (found.verdict != Verdict::accepted) throw std::runtime_error(found.reason);
    const Pose& T = found.T_target_source;
    return {robot_movement(DirectionTimes(second), source.data(), target.data(), T), "",
            scene_movement(source.data(), target.data(), T)};
  }

  /// A sweep before the movement and one after it, cut where it happened.
  Sweep disturbed(const Disturbance& by) const {
    Sweep sweep = take(X_world_second_, by.people, 2 * seed_ + 1);
    if (by.after_s == 0.0) return sweep;
    Pose X_world_moved = X_world_second_ * Eigen::Translation3d(by.shift);
    X_world_moved.linear() *= rotation_about_z(by.turn);
    const Sweep moved = take(X_world_moved, by.people, 2 * seed_ + 1);
    const auto moment = static_cast<std::int32_t>(1e6 * (by.after_s - duration_s(sweep)));
    Sweep cut = sweep;
    cut.cloud = {};
    cut.time_offset_us.clear();
    append(sweep, cut, [&](std::int32_t time) { return time < moment; });
    append(moved, cut, [&](std::int32_t time) { return time >= moment; });
    return cut;
  }

 private:
  static double duration_s(const Sweep& sweep) { return -1e-6 * sweep.time_offset_us.front(); }

  template <class Keep>
  static void append(const Sweep& from, Sweep& to, const Keep& keep) {
    for (std::size_t i = 0; i < from.cloud.size(); ++i) {
      if (!keep(from.time_offset_us[i])) continue;
      to.cloud.points.push_back(from.cloud.points[i]);
      to.time_offset_us.push_back(from.time_offset_us[i]);
    }
  }

  Sweep take(const Pose& X_world_base, int people, std::uint64_t seed) const {
    simulator::SweepConfig config;
    config.seed = seed;
    config.thin = thin_;
    config.people = people;
    Sweep sweep = simulator::points_of(simulator::simulate_lines(caster_, robot_, X_world_base, config), robot_).sweep;
    sweep.R_world_sweep = simulator::Tracker(robot_.tracker, X_world_base, seed).mean();
    return sweep;
  }

  PreparedScan prepared(const Sweep& sweep) const { return PreparedScan::make(sweep.cloud, sweep.origin, config_); }

  const Robot robot_{};
  const RegistrationConfig config_{robot_.laser.min_range_m, robot_.laser.max_range_m, 1};
  simulator::World world_;
  simulator::RayCaster caster_;
  std::uint64_t seed_;
  int thin_;
  Pose X_world_first_, X_world_second_;
  Sweep first_;
};

}  // namespace scanway::testing
