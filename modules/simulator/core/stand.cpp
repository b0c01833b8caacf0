#include "modules/simulator/core/stand.h"

#include <array>
#include <cmath>

#include "common/math/repeatable.h"
#include "modules/simulator/core/ray/ray_caster.h"

namespace scanway::simulator {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kSky_m = 500.0;

/// Half length and half width of the box around the footprint.
Vector2d half_size(const std::vector<Vector2d>& footprint) {
  Vector2d half = Vector2d::Zero();
  for (const Vector2d& corner : footprint) half = half.cwiseMax(corner.cwiseAbs());
  return half;
}

std::string problem_of(CellTruth truth, const World& world) {
  switch (truth) {
    case CellTruth::occupied:
      return "in a wall or another thing";
    case CellTruth::drop_off:
      return "on the edge of a drop";
    case CellTruth::unknown: {
      const auto whole = [](double metres) { return std::to_string(static_cast<int>(std::lround(metres))); };
      return "outside the world, which reaches from " + whole(world.extent.low.x()) + "," +
             whole(world.extent.low.y()) + " to " + whole(world.extent.high.x()) + "," + whole(world.extent.high.y());
    }
    default:
      return "";
  }
}

std::string problem_under(const World& world, const Robot& robot, const Place& place) {
  const double reach = robot.circumscribed_radius_m() + 0.05;
  const Vector2d centre(place.x, place.y);
  const Rectangle window{centre.array() - reach, centre.array() + reach};
  return problem_on(make_truth(world, robot.body, kTruthCell_m, window), world, robot, place);
}

}  // namespace

std::string problem_on(const TruthGrid& truth, const World& world, const Robot& robot, const Place& place) {
  const double c = repeatable::cos(place.heading), s = repeatable::sin(place.heading);
  const Vector2d half = half_size(robot.body.footprint);
  for (double x = -half.x(); x <= half.x(); x += kTruthCell_m / 2) {
    for (double y = -half.y(); y <= half.y(); y += kTruthCell_m / 2) {
      const CellTruth here = truth.at(place.x + c * x - s * y, place.y + s * x + c * y);
      if (here != CellTruth::free) return problem_of(here, world);
    }
  }
  return "";
}

Stand stand_at(const World& world, const Robot& robot, const Place& place) {
  Stand stand;
  stand.problem = problem_under(world, robot, place);
  if (!stand.problem.empty()) return stand;
  const RayCaster ground(std::array{&world.ground});
  const Vector2d half = half_size(robot.body.footprint) * 0.9;
  const double c = repeatable::cos(place.heading), s = repeatable::sin(place.heading);
  const auto wheel = [&](double x, double y) {
    const double wx = place.x + c * x - s * y, wy = place.y + s * x + c * y;
    const auto hit = ground.cast({wx, wy, kSky_m}, -Vector3d::UnitZ(), 2 * kSky_m);
    return Vector3d(wx, wy, hit ? kSky_m - hit->range_m : 0.0);
  };
  const Vector3d front_left = wheel(half.x(), half.y()), front_right = wheel(half.x(), -half.y());
  const Vector3d rear_left = wheel(-half.x(), half.y()), rear_right = wheel(-half.x(), -half.y());
  const Vector3d ahead = (front_left + front_right) - (rear_left + rear_right);
  const Vector3d left = (front_left + rear_left) - (front_right + rear_right);
  Eigen::Matrix3d R;
  R.col(0) = ahead.normalized();
  R.col(2) = ahead.cross(left).normalized();
  R.col(1) = R.col(2).cross(R.col(0));
  stand.X_world_base.linear() = R;
  stand.X_world_base.translation() = (front_left + front_right + rear_left + rear_right) / 4;
  return stand;
}

}  // namespace scanway::simulator
