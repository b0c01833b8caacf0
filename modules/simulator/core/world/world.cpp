#include "modules/simulator/core/world/world.h"

#include <algorithm>
#include <stdexcept>

#include "common/math/repeatable.h"
#include "modules/simulator/core/world/builders.h"

namespace scanway::simulator {
namespace {

using Eigen::Vector2d;

struct Builder {
  WorldKind kind;
  void (*build)(World&);
};

const std::vector<Builder>& builders() {
  static const std::vector<Builder> kBuilders = {
      {{"yard", "a factory's yard: buildings around, containers, pallets, a shed, trees"}, build_yard},
      {{"street", "streets round a block of houses, kerbs of 12 cm, parked cars, trees, lamps"}, build_street},
      {{"hall", "a roofed hall: pillars in rows, machines, shelves, gates"}, build_hall},
      {{"car_park", "rows of bays, most with a car, islands with trees, a ticket booth"}, build_car_park},
      {{"rubble", "a fallen house: slabs, beams and blocks, walls that still stand"}, build_rubble},
      {{"corridor", "a straight corridor of 200 m, the same at every metre"}, build_corridor},
      {{"field", "open grass with nothing on it"}, build_field},
      {{"ramp", "a slope of 4 degrees with a ramp of 7 degrees up to a loading dock"}, build_ramp},
      {{"trench", "a building site with a trench of 1.2 m and heaps beside it"}, build_trench},
      {{"kerbs", "a square with islands behind kerbs of 5 and 12 cm"}, build_kerbs},
      {{"flat", "a level court with boxes, posts and walls"}, build_flat},
      {{"slope", "the same on a slope of 10 degrees"}, build_slope},
  };
  return kBuilders;
}

double length_of(const std::vector<Vector2d>& corners) {
  double length = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) length += (corners[i] - corners[i - 1]).norm();
  return length;
}

Place place_at(const std::vector<Vector2d>& corners, double along) {
  std::size_t i = 1;
  for (; i + 1 < corners.size(); ++i) {
    const double leg = (corners[i] - corners[i - 1]).norm();
    if (along <= leg) break;
    along -= leg;
  }
  const Vector2d direction = (corners[i] - corners[i - 1]).normalized();
  const Vector2d at = corners[i - 1] + std::min(along, (corners[i] - corners[i - 1]).norm()) * direction;
  return {at.x(), at.y(), repeatable::atan2(direction.y(), direction.x())};
}

}  // namespace

const std::vector<WorldKind>& world_kinds() {
  static const std::vector<WorldKind> kKinds = [] {
    std::vector<WorldKind> kinds;
    for (const Builder& builder : builders()) kinds.push_back(builder.kind);
    return kinds;
  }();
  return kKinds;
}

World make_world(std::string_view name, std::uint64_t seed) {
  const auto found = std::find_if(builders().begin(), builders().end(),
                                  [&](const Builder& builder) { return builder.kind.name == name; });
  if (found == builders().end()) throw std::invalid_argument("no world of the name " + std::string(name));
  World world;
  world.name = name;
  world.seed = seed;
  found->build(world);
  return world;
}

std::vector<Place> places_on_route(const World& world, int count, double spacing_m, double start_m) {
  std::vector<Vector2d> corners = world.route;
  if (world.route_is_loop) corners.push_back(corners.front());
  const double length = length_of(corners);
  if (spacing_m <= 0.0) spacing_m = length / (world.route_is_loop ? count : std::max(1, count - 1));
  std::vector<Place> places;
  for (int i = 0; i < count; ++i) {
    double along = start_m + i * spacing_m;
    while (world.route_is_loop && along >= length) along -= length;
    places.push_back(place_at(corners, along));
  }
  return places;
}

}  // namespace scanway::simulator
