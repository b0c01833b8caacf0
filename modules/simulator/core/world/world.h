#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "modules/simulator/core/world/ground_plan.h"
#include "modules/simulator/core/world/mesh.h"

namespace scanway::simulator {

/// A place to scan, with its truth. Frame `world`: z up, metres. Beyond `extent` there is nothing.
struct World {
  std::string name;
  std::uint64_t seed = 0;
  Rectangle extent;
  Mesh ground;   ///< What the robot can stand on: one height at each point, upright faces between levels.
  Mesh objects;  ///< All else.
  /// A way through the world that the robot can drive, corner by corner; where `route_is_loop`, back to its start.
  std::vector<Eigen::Vector2d> route;
  bool route_is_loop = false;
};

struct WorldKind {
  std::string_view name;
  std::string_view what;  ///< One line for people.
};

const std::vector<WorldKind>& world_kinds();

/// The world of that name, which is one of world_kinds(). The same seed gives the same world, another one another.
/// Throws std::invalid_argument for another name.
World make_world(std::string_view name, std::uint64_t seed);

/// A place on the world's route.
struct Place {
  double x = 0.0, y = 0.0, heading = 0.0;
};

/// `count` places along the route, `spacing_m` apart, the first `start_m` after the route's start; headings along it.
/// A loop goes on from its end, another route stops there. A `spacing_m` of 0 spreads them evenly.
std::vector<Place> places_on_route(const World& world, int count, double spacing_m = 0.0, double start_m = 0.0);

}  // namespace scanway::simulator
