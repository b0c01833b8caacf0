#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/random/random.h"
#include "common/robot/robot.h"
#include "modules/planner/core/planner.h"
#include "tests/modules/planner/support/maps.h"

namespace scanway::test {

struct TrialBody {
  const char* name;
  Robot robot;
  double resolution_m;  ///< Of random maps that are neither too easy nor too hard for it,
  double share;         ///< and how much of them is obstacles.
};

/// ERA-Mobi, a box of 1.2 m x 0.5 m, and a car of 4.5 m x 1.8 m whose centre is over its rear axle.
const std::vector<TrialBody>& trial_bodies();

/// The truth of a simulated world as that body meets it.
TestMap truth_map(const std::string& world, std::uint64_t seed, const Robot& robot, double resolution_m);

/// The middle of the map's file of ../shared/data/occupancy_maps; nothing known when it is not there.
TestMap recorded_map(const std::string& name);

struct Tally {
  int ways = 0;
  int none = 0;
  double cost = 0.0;     ///< Of all ways,
  double seconds = 0.0;  ///< and how long they take.
};

/// Plans between random places where the body fits. Every path must be clear by polygons, cost no more by an integral
/// along it than the search says, and keep the robot's limits; else a test fails here.
Tally try_random_problems(const TestMap& map, const Robot& robot, int problems, Random& random,
                          std::optional<planning::PathForm> form = std::nullopt);

/// One problem on each of so many small random maps: the planner must find a way where a search of all (x, y, heading)
/// finds one, at its cost; else a test fails here.
Tally try_against_exhaustive_search(const TrialBody& body, int maps, Random& random);

/// Whether times and speeds fit the way and the body's limits; empty: they do.
std::string fault_in_drive(const std::vector<planning::PathPose>& path, const Robot::Body& body);

}  // namespace scanway::test
