#include "modules/mapper/core/ground/ground_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "modules/mapper/core/ground/column_offsets.h"

/// Ground beside the ground: levels that cannot be reached.
namespace scanway {
namespace {

constexpr double kLargestThing = 15.0;      // m^2: what leans and is larger is a ramp
constexpr int kRingsApart = 10;             // columns
constexpr std::size_t kMostFurniture = 10;  // of so many columns of a level one may be too high
constexpr int kSearch = 30;                 // columns: how far the nearest ground is looked for
constexpr double kMostWithin = 4;           // times as many points on a level as off it make a column flat
constexpr double kLevelUnit = 1e-4;         // metres: of heights
constexpr double kLevelTilt = 0.08;         // metres a metre against the ground: what is steeper leans on it

/// Of a square, with what it carries around it: far from the sensor its own columns are few.
double area_when_dilated(double area) {
  const double side = std::sqrt(area) + 2 * GroundSurface::kReach * GroundSurface::kColumn;
  return side * side;
}

}  // namespace

bool GroundSurface::flat(std::size_t column, std::int32_t& height) const {
  const std::size_t begin = first_[column], end = first_[column + 1];
  if (end - begin < 2) return false;
  std::vector<std::int32_t> heights;
  for (std::size_t i = begin; i < end; ++i) heights.push_back(points_[i].u);
  std::nth_element(heights.begin(), heights.begin() + heights.size() / 2, heights.end());
  height = heights[heights.size() / 2];
  const auto within =
      std::count_if(heights.begin(), heights.end(), [&](std::int32_t u) { return std::abs(u - height) <= band_; });
  return static_cast<double>(within) >= kMostWithin * static_cast<double>(heights.size() - within);
}

std::int32_t GroundSurface::nearest_ground(std::size_t column) const {
  const int cx = static_cast<int>(column % side_), cy = static_cast<int>(column / side_);
  for (int ring = 1; ring <= kSearch; ++ring) {
    for (int y = -ring; y <= ring; ++y) {
      const int step = std::abs(y) == ring ? 1 : 2 * ring;
      for (int x = -ring; x <= ring; x += step) {
        if (inside(cx + x, cy + y) && columns_[index(cx + x, cy + y)].joined) return mean(index(cx + x, cy + y));
      }
    }
  }
  return 0;
}

bool GroundSurface::is_level(const std::vector<std::size_t>& columns) const {
  PlaneSums sums;
  for (const std::size_t column : columns) {
    const double cx = static_cast<double>(column % side_), cy = static_cast<double>(column / side_);
    sums.add({cx * kColumn, cy * kColumn, mean(column) * kLevelUnit});
  }
  const LocalPlane plane = sums.plane();
  return std::sqrt(plane.a * plane.a + plane.b * plane.b) <= kLevelTilt;
}

void GroundSurface::keep_if_level(const std::vector<std::size_t>& columns) {
  if (is_level(columns) || area_around(columns) >= area_when_dilated(kLargestThing)) return;
  for (const std::size_t column : columns) columns_[column] = Column{};
}

double GroundSurface::area_around(const std::vector<std::size_t>& columns) const {
  static const std::vector<Eigen::Vector2i> kCarried = offsets_within(kReach);
  std::vector<std::size_t> around;
  for (const std::size_t column : columns) {
    const int cx = static_cast<int>(column % side_), cy = static_cast<int>(column / side_);
    for (const Eigen::Vector2i& offset : kCarried) {
      if (inside(cx + offset.x(), cy + offset.y())) around.push_back(index(cx + offset.x(), cy + offset.y()));
    }
  }
  std::sort(around.begin(), around.end());
  const auto different = std::unique(around.begin(), around.end()) - around.begin();
  return static_cast<double>(different) * kColumn * kColumn;
}

void GroundSurface::leave(const std::vector<std::size_t>& columns, std::vector<bool>& tried) {
  for (const std::size_t column : columns) columns_[column] = Column{}, tried[column] = true;
}

bool GroundSurface::try_level(std::size_t seed, std::vector<bool>& tried) {
  std::int32_t height = 0;
  if (!flat(seed, height)) return false;
  const std::int32_t below = nearest_ground(seed);
  if ((height - below) * kLevelUnit > config_.highest_level_m || !join(seed, height)) return false;
  // Far from the sensor a level shows in rings, so far apart.
  static const std::vector<Eigen::Vector2i> kRings = offsets_within(kRingsApart);
  std::vector<std::size_t> level = grow({seed}, kRings);
  const auto high = std::stable_partition(level.begin(), level.end(), [&](std::size_t column) {
    return (mean(column) - below) * kLevelUnit <= config_.highest_level_m;
  });
  const std::vector<std::size_t> furniture(high, level.end());  // Such as the foot of a tree that stands there.
  level.erase(high, level.end());
  leave(furniture, tried);
  const bool low = furniture.size() * kMostFurniture <= level.size();
  if (low && is_level(level) && area_around(level) >= area_when_dilated(config_.least_level_m2)) return true;
  leave(level, tried);
  return false;
}

void GroundSurface::join_levels() {
  if (!std::isfinite(config_.least_level_m2)) return;
  std::vector<bool> tried(columns_.size());
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if (columns_[column].joined || tried[column] || empty(column)) continue;
    tried[column] = true;
    try_level(column, tried);
  }
}

}  // namespace scanway
