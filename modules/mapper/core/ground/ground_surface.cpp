#include "modules/mapper/core/ground/ground_surface.h"

#include <algorithm>
#include <cmath>

#include "modules/mapper/core/ground/column_offsets.h"

namespace scanway {
namespace {

constexpr double kUnit = 1e-4;       // of heights
constexpr double kMaxHeight = 3.0;   // of points above or below the ground plane that may yet be ground
constexpr double kStartRange = 2.0;  // floor this near to the robot is what it stands on

std::int32_t to_units(double metres) { return static_cast<std::int32_t>(std::floor(metres / kUnit + 0.5)); }

/// Those within reach of a column.
const std::vector<Eigen::Vector2i>& reachable() {
  static const std::vector<Eigen::Vector2i> offsets = offsets_within(GroundSurface::kReach);
  return offsets;
}

}  // namespace

GroundSurface::GroundSurface(const MapPoints& points, const GroundPlane& plane, const GroundSurfaceConfig& config)
    : plane_(plane), config_(config), band_(to_units(config.climbable_step_m + config.range_sigma_m)) {
  const int half = static_cast<int>(std::ceil(config.max_range_m / kColumn));
  side_ = 2 * half;
  corner_x_ = (std::floor(points.origin.x() / kColumn) - half) * kColumn;
  corner_y_ = (std::floor(points.origin.y() / kColumn) - half) * kColumn;
  columns_.resize(static_cast<std::size_t>(side_) * side_);
  sort_points(points);
  start_around_robot();
  cross_gaps();
  join_levels();
  find_faces();
  find_steps();
  for (int cy = 0; cy < side_; ++cy) {
    for (int cx = 0; cx < side_; ++cx) fit_column(cx, cy);
  }
  fill_outwards();
}

void GroundSurface::sort_points(const MapPoints& points) {
  std::vector<Point> unsorted;
  first_.assign(columns_.size() + 1, 0);
  for (const Eigen::Vector3f& p : points.points) {
    const double x = (p.x() - corner_x_) / kColumn, y = (p.y() - corner_y_) / kColumn;
    const double u = p.z() - plane_.height_at(p.x(), p.y());
    if (!(x >= 0.0 && y >= 0.0 && x < side_ && y < side_) || std::fabs(u) > kMaxHeight) continue;
    const int cx = static_cast<int>(x), cy = static_cast<int>(y);
    const auto within = [](double v, int c) { return static_cast<std::int16_t>((v - c) * kColumn / kUnit); };
    unsorted.push_back({index(cx, cy), within(x, cx), within(y, cy), to_units(u)});
    ++first_[unsorted.back().key + 1];
  }
  for (std::size_t c = 0; c < columns_.size(); ++c) first_[c + 1] += first_[c];
  points_.resize(unsorted.size());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const Point& point : unsorted) points_[next[point.key]++] = point;
}

bool GroundSurface::join(std::size_t which, std::int32_t expected) {
  Column& column = columns_[which];
  if (column.joined || empty(which)) return false;
  // Twice: the second time about the mean of the first, so that half of a small step is not cut off.
  for (int round = 0; round < 2; ++round) {
    Column ground;
    int off = 0;
    for (std::size_t i = first_[which]; i < first_[which + 1]; ++i) {
      const Point& p = points_[i];
      const std::int32_t over = p.u - expected;
      off += std::abs(over) > band_ && std::abs(over) <= band_ + 1000 ? 1 : 0;
      if (std::abs(over) > band_) continue;
      ground.x_sum += p.x, ground.y_sum += p.y, ground.u_sum += p.u, ++ground.count;
    }
    // The lower flank of something higher and the edge of a pit are no floor: most of what is near the expected height
    // must be at it.
    if (ground.count == 0 || 2 * ground.count < off) return false;
    column = ground;
    expected = ground.u_sum / ground.count;
  }
  column.joined = true;
  return true;
}

std::vector<std::size_t> GroundSurface::grow(std::vector<std::size_t> front,
                                             const std::vector<Eigen::Vector2i>& reach) {
  for (std::size_t next = 0; next < front.size(); ++next) {  // first in, first out
    const int cx = static_cast<int>(front[next] % side_), cy = static_cast<int>(front[next] / side_);
    std::optional<Plane> ahead;
    for (const Eigen::Vector2i& offset : reach) {
      const int x = cx + offset.x(), y = cy + offset.y();
      if (!inside(x, y) || columns_[index(x, y)].joined || empty(index(x, y))) continue;
      if (!ahead) ahead = ahead_of(front[next]);
      if (join(index(x, y), to_units(ahead->at(offset.x() * kColumn, offset.y() * kColumn)))) {
        front.push_back(index(x, y));
      }
    }
  }
  return front;
}

void GroundSurface::start_around_robot() {
  const int centre = side_ / 2;
  std::vector<std::size_t> front;
  // Floor within reach of where the robot stands; failing that, the nearest ring that shows any.
  for (double range = kStartRange; front.empty() && range < config_.max_range_m; range += 1.0) {
    const int radius = static_cast<int>(range / kColumn);
    for (int y = -radius; y <= radius; ++y) {
      for (int x = -radius; x <= radius; ++x) {
        if (x * x + y * y > radius * radius || !inside(centre + x, centre + y)) continue;
        if (join(index(centre + x, centre + y), 0)) front.push_back(index(centre + x, centre + y));
      }
    }
  }
  grow(std::move(front), reachable());
}

void GroundSurface::cross_gaps() {
  // Square rings outwards, so that whatever lies towards the robot has been decided before.
  const int centre = side_ / 2;
  for (int ring = 1; ring < centre; ++ring) {
    for (int y = -ring; y <= ring; ++y) {
      const int step = std::abs(y) == ring ? 1 : 2 * ring;
      for (int x = -ring; x <= ring; x += step) {
        const std::size_t column = index(centre + x, centre + y);
        if (columns_[column].joined || empty(column)) continue;
        std::int32_t expected = 0;
        for (int r = ring - 1; r > 0; --r) {  // the nearest joined column on the line to the robot
          const Column& towards = columns_[index(centre + x * r / ring, centre + y * r / ring)];
          if (!towards.joined) continue;
          expected = towards.u_sum / towards.count;
          break;
        }
        if (join(column, expected)) keep_if_level(grow({column}, reachable()));
      }
    }
  }
}

GroundSurface::Place GroundSurface::at(double x, double y) const {
  Place place{false, 0, plane_.height_at(x, y), plane_.slope_x, plane_.slope_y};
  const double fx = (x - corner_x_) / kColumn, fy = (y - corner_y_) / kColumn;
  if (!(fx >= 0.0 && fy >= 0.0 && fx < side_ && fy < side_)) return place;
  const int cx = static_cast<int>(fx), cy = static_cast<int>(fy);
  const Column& column = columns_[index(cx, cy)];
  place.carried = column.carried;
  place.support = column.support;
  place.slope_x += column.slope_x;
  place.slope_y += column.slope_y;
  place.height += column.height + (column.slope_x * (fx - cx - 0.5) + column.slope_y * (fy - cy - 0.5)) * kColumn;
  return place;
}

bool GroundSurface::carries_within(double x0, double y0, double x1, double y1) const {
  const auto column = [this](double v, double corner) {
    return static_cast<int>(std::clamp(std::floor((v - corner) / kColumn), -1.0, static_cast<double>(side_)));
  };
  const int cx1 = std::min(column(x1, corner_x_), side_ - 1), cy1 = std::min(column(y1, corner_y_), side_ - 1);
  for (int cy = std::max(column(y0, corner_y_), 0); cy <= cy1; ++cy) {
    for (int cx = std::max(column(x0, corner_x_), 0); cx <= cx1; ++cx) {
      if (columns_[index(cx, cy)].carried) return true;
    }
  }
  return false;
}

double GroundSurface::area_m2() const {
  const auto joined = std::count_if(columns_.begin(), columns_.end(), [](const Column& c) { return c.joined; });
  return static_cast<double>(joined) * kColumn * kColumn;
}

}  // namespace scanway
