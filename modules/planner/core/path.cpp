#include "modules/planner/core/path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/repeatable.h"

namespace scanway::planning {
namespace {

int step_between(Cell a, Cell b) {
  int step = 0;
  while (kStepX[static_cast<std::size_t>(step)] != b.x - a.x || kStepY[static_cast<std::size_t>(step)] != b.y - a.y)
    ++step;
  return step;
}

}  // namespace

std::vector<PathPose> poses_of(const Route& route, const MapScale& scale) {
  std::vector<PathPose> poses;
  const auto add = [&](Cell cell, int heading) {
    const Eigen::Vector2d at = scale.middle_of(cell);
    const PathPose pose = {at.x(), at.y(), angle_of(heading)};
    if (poses.empty() || poses.back() != pose) poses.push_back(pose);
  };
  for (std::size_t i = 0; i + 1 < route.places.size(); ++i) {
    const Place& here = route.places[i];
    const Place& next = route.places[i + 1];
    if (here.cell == next.cell) {  // A turn in place.
      add(here.cell, *here.heading);
      add(next.cell, *next.heading);
      continue;
    }
    const int heading = here.heading   ? *here.heading
                        : next.heading ? *next.heading
                                       : 2 * step_between(here.cell, next.cell);
    add(here.cell, heading);
    add(next.cell, heading);
  }
  if (poses.empty()) add(route.places.front().cell, route.places.front().heading.value_or(0));
  return poses;
}

namespace {

/// Distance between two segments' nearest points where they do not cross: an end of one is among them.
double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d edge = b - a;
  const double length2 = edge.squaredNorm();
  const double along = length2 > 0.0 ? std::clamp((p - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
  return (a + along * edge - p).norm();
}

double distance_to_square(const Eigen::Vector2d& p, Cell cell) {
  const double dx = std::max(std::fabs(p.x() - cell.x) - 0.5, 0.0);
  const double dy = std::max(std::fabs(p.y() - cell.y) - 0.5, 0.0);
  return std::sqrt(dx * dx + dy * dy);
}

/// Between a polygon and a cell's square that do not overlap, in cells.
double distance_to_cell(const Polygon& polygon, Cell cell) {
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    distance = std::min(distance, distance_to_square(a, cell));
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5})
        distance = std::min(distance, distance_to_segment({cell.x + x, cell.y + y}, a, b));
    }
  }
  return distance;
}

/// The least distance from the body's poses to an occupied cell.
class Clearance {
 public:
  Clearance(const Terrain& terrain, bool with_footprint)
      : terrain_(&terrain),
        reach_(with_footprint ? terrain.body().circumscribed() : 0.0),
        with_footprint_(with_footprint) {}

  /// At `at` (in cells); returns whether it is the least so far.
  bool add(const Eigen::Vector2d& at, double heading) {
    const double before = least_;
    polygon_ = {at};
    if (with_footprint_) {
      polygon_ =
          placed(terrain_->body().footprint(), repeatable::cos(heading), repeatable::sin(heading), at.x(), at.y());
    }
    const CellRectangle& bounds = terrain_->bounds();
    const double widest = reach_ + static_cast<double>(std::max(bounds.width(), bounds.height())) + 2.0;
    if (before != kNone) look(at, least_ + reach_ + 1.0);
    // Doubling the window until something is found; then only what may be nearer.
    for (double window = 16.0 + reach_; least_ == kNone && !none_; window *= 2.0) {
      look(at, window);
      none_ = least_ == kNone && window > widest;
    }
    if (before == kNone && !none_) look(at, least_ + reach_ + 1.0);
    return least_ < before;
  }
  double least() const { return least_; }

 private:
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  void look(const Eigen::Vector2d& at, double window) {
    const Frame& frame = terrain_->frame();
    const auto limit = [](double value, std::int32_t low, std::int32_t size) {
      return static_cast<std::int32_t>(std::clamp(value - low, 0.0, size - 1.0));
    };
    const std::int32_t y1 = limit(std::ceil(at.y() + window), frame.low.y, frame.height);
    const std::int32_t x0 = limit(std::floor(at.x() - window), frame.low.x, frame.width) >> 6;
    const std::int32_t x1 = limit(std::ceil(at.x() + window), frame.low.x, frame.width) >> 6;
    for (std::int32_t y = limit(std::floor(at.y() - window), frame.low.y, frame.height); y <= y1; ++y) {
      for (std::int32_t x = x0; x <= x1; ++x) {
        for (std::uint64_t word = terrain_->occupied().word(y, x); word != 0; word &= word - 1) {
          hold(at, {frame.low.x + x * 64 + __builtin_ctzll(word), frame.low.y + y});
        }
      }
    }
  }

  void hold(const Eigen::Vector2d& at, Cell cell) {
    if (distance_to_square(at, cell) - reach_ >= least_) return;
    least_ = std::min(least_, distance_to_cell(polygon_, cell));
  }

  const Terrain* terrain_;
  double reach_;
  bool with_footprint_;
  Polygon polygon_;
  double least_ = kNone;
  bool none_ = false;  ///< There is no occupied cell at all.
};

/// The share of the segment a-b (in cells) that lies in unknown cells: by points a tenth of a cell apart.
double unknown_length(const Terrain& terrain, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double length = (b - a).norm();
  const int parts = std::max(2, 2 * static_cast<int>(std::ceil(5.0 * length)));
  int unknown = 0;
  for (int i = 0; i < parts; ++i) {
    const Eigen::Vector2d p = a + (b - a) * ((i + 0.5) / parts);
    const Cell cell = {static_cast<std::int32_t>(std::floor(p.x() + 0.5)),
                       static_cast<std::int32_t>(std::floor(p.y() + 0.5))};
    if (terrain.is_unknown(cell)) ++unknown;
  }
  return length * unknown / parts;
}

}  // namespace

void measure(PlanResult& result, const Terrain& terrain, const MapScale& scale) {
  Clearance clearance(terrain, terrain.options().mode == BodyMode::footprint);
  double length = 0.0;
  double unknown = 0.0;
  for (std::size_t i = 0; i < result.path.size(); ++i) {
    const PathPose& pose = result.path[i];
    const Eigen::Vector2d at = scale.to_cells(pose.x_m, pose.y_m);
    if (clearance.add(at, pose.heading)) result.clearance_at_m = {pose.x_m, pose.y_m};
    if (i == 0) continue;
    const Eigen::Vector2d before = scale.to_cells(result.path[i - 1].x_m, result.path[i - 1].y_m);
    length += (at - before).norm();
    unknown += unknown_length(terrain, before, at);
  }
  result.length_m = length * scale.resolution_m;
  result.unknown_share = length > 0.0 ? unknown / length : 0.0;
  result.clearance_m = clearance.least() * scale.resolution_m;
}

}  // namespace scanway::planning
