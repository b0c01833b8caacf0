#include "modules/planner/core/path/measure.h"

#include <algorithm>
#include <cmath>

#include "modules/planner/core/path/clearance.h"
#include "modules/planner/core/path/line.h"

namespace scanway::planning {
namespace {

/// A share that only rounding gives to a cell.
constexpr double kTouch = 1e-12;

/// Calls visit(at, heading) from pose to pose, so near one another that no point of the body moves more than a cell.
template <class Visit>
void for_poses_between(const PathPose& a, const PathPose& b, const Ground& ground, const MapScale& scale,
                       Visit&& visit) {
  const Eigen::Vector2d from = scale.to_cells(a.x_m, a.y_m), way = scale.to_cells(b.x_m, b.y_m) - from;
  const double turn = wrapped(b.heading - a.heading);
  const double swing = ground.has_body() ? ground.body().circumscribed() * std::fabs(turn) : 0.0;
  const int parts = std::max(1, static_cast<int>(std::ceil(way.norm() + swing)));
  for (int i = 1; i <= parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    visit(from + share * way, a.heading + share * turn);
  }
}

double unknown_length(const Ground& ground, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  double share = 0.0;
  for_cells_on(
      a, b, [&](Cell cell, double part) { share += part > kTouch && ground.terrain().is_unknown(cell) ? part : 0.0; });
  return share * (b - a).norm();
}

}  // namespace

PathMeasures measures_of(const std::vector<PathPose>& path, const Ground& ground, const MapScale& scale) {
  PathMeasures measures;
  Clearance clearance(ground.terrain());
  double length = 0.0, unknown = 0.0;
  const Eigen::Vector2d first = scale.to_cells(path.front().x_m, path.front().y_m);
  measures.worst_cost = ground.dearest_on(first, first);
  const auto pass = [&](const Eigen::Vector2d& at, double heading) {
    if (clearance.add(at, heading)) measures.clearance_at_m = scale.to_metres(at);
  };
  pass(first, path.front().heading);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Eigen::Vector2d a = scale.to_cells(path[i].x_m, path[i].y_m);
    const Eigen::Vector2d b = scale.to_cells(path[i + 1].x_m, path[i + 1].y_m);
    for_poses_between(path[i], path[i + 1], ground, scale, pass);
    length += (b - a).norm();
    unknown += unknown_length(ground, a, b);
    measures.worst_cost = std::max(measures.worst_cost, ground.dearest_on(a, b));
  }
  measures.length_m = length * scale.resolution_m;
  measures.unknown_share = length > 0.0 ? unknown / length : 0.0;
  measures.clearance_m = clearance.least() * scale.resolution_m;
  return measures;
}

}  // namespace scanway::planning
