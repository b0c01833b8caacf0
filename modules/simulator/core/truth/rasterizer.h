#pragma once

#include <cmath>
#include <cstdint>

#include "modules/simulator/core/world/mesh.h"

namespace scanway::simulator {

/// Part of a grid: cell (x, y) covers [x, x + 1) x [y, y + 1) times the resolution. From low up to and without high.
struct CellWindow {
  double resolution_m = 0.01;
  std::int32_t low_x = 0, low_y = 0, high_x = 0, high_y = 0;

  std::int32_t width() const { return high_x - low_x; }
  std::size_t size() const { return static_cast<std::size_t>(width()) * static_cast<std::size_t>(high_y - low_y); }
  std::size_t index(std::int32_t x, std::int32_t y) const {
    return static_cast<std::size_t>(y - low_y) * static_cast<std::size_t>(width()) +
           static_cast<std::size_t>(x - low_x);
  }
  double centre(std::int32_t i) const { return (i + 0.5) * resolution_m; }
  std::int32_t cell(double metres) const { return static_cast<std::int32_t>(std::floor(metres / resolution_m)); }
};

/// A triangle seen from above.
class FlatTriangle {
 public:
  explicit FlatTriangle(const Corners& corners);

  /// +1 when its upper side is seen from above, -1 when its lower side is, 0 when it stands upright.
  int facing() const { return facing_; }
  double height_at(double x, double y) const {
    return corners_[0].z() + slope_x_ * (x - corners_[0].x()) + slope_y_ * (y - corners_[0].y());
  }
  /// Of triangles that share an edge and cover the point on it exactly one says yes.
  bool covers(double x, double y) const;

  double low(int axis) const { return low_[axis]; }
  double high(int axis) const { return high_[axis]; }

 private:
  Corners corners_;  // Counter-clockwise seen from above.
  Eigen::Vector3d low_, high_;
  int facing_ = 0;
  double slope_x_ = 0.0, slope_y_ = 0.0;
};

/// Calls visit(x, y, height) for the cells of `window` whose centre the triangle covers.
template <class Visit>
void for_centres(const FlatTriangle& triangle, const CellWindow& window, const Visit& visit);

/// Calls visit(x, y, low_z, high_z) for the cells of `window` that the triangle passes through, with the heights
/// between which it does.
template <class Visit>
void for_touched(const Corners& corners, const CellWindow& window, const Visit& visit);

}  // namespace scanway::simulator

#include "modules/simulator/core/truth/rasterizer_impl.h"
