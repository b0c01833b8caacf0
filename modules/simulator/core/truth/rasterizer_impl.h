#pragma once

#include <algorithm>
#include <array>

#include "modules/simulator/core/truth/rasterizer.h"

namespace scanway::simulator {

template <class Visit>
void for_centres(const FlatTriangle& triangle, const CellWindow& window, const Visit& visit) {
  if (triangle.facing() == 0) return;
  const std::int32_t x0 = std::max(window.low_x, window.cell(triangle.low(0)));
  const std::int32_t x1 = std::min(window.high_x - 1, window.cell(triangle.high(0)));
  const std::int32_t y0 = std::max(window.low_y, window.cell(triangle.low(1)));
  const std::int32_t y1 = std::min(window.high_y - 1, window.cell(triangle.high(1)));
  for (std::int32_t y = y0; y <= y1; ++y) {
    for (std::int32_t x = x0; x <= x1; ++x) {
      const double cx = window.centre(x), cy = window.centre(y);
      if (triangle.covers(cx, cy)) visit(x, y, triangle.height_at(cx, cy));
    }
  }
}

/// A convex polygon of a few corners, cut by planes along the axes (Sutherland and Hodgman, CACM 17(1), 1974).
struct ClippedPolygon {
  std::array<Eigen::Vector3d, 8> corners;
  int count = 0;

  /// What of it has sign * (p[axis] - at) >= 0.
  ClippedPolygon cut(int axis, double at, double sign) const {
    ClippedPolygon out;
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d &p = corners[static_cast<std::size_t>(i)],
                            &q = corners[static_cast<std::size_t>((i + 1) % count)];
      const double dp = sign * (p[axis] - at), dq = sign * (q[axis] - at);
      if (dp >= 0) out.corners[static_cast<std::size_t>(out.count++)] = p;
      if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) {
        out.corners[static_cast<std::size_t>(out.count++)] = p + (dp / (dp - dq)) * (q - p);
      }
    }
    return out;
  }
  double low(int axis) const {
    double least = corners[0][axis];
    for (int i = 1; i < count; ++i) least = std::min(least, corners[static_cast<std::size_t>(i)][axis]);
    return least;
  }
  double high(int axis) const {
    double most = corners[0][axis];
    for (int i = 1; i < count; ++i) most = std::max(most, corners[static_cast<std::size_t>(i)][axis]);
    return most;
  }
};

template <class Visit>
void for_touched(const Corners& corners, const CellWindow& window, const Visit& visit) {
  constexpr double kOpen_m = 1e-9;  // A cell does not have its upper edges.
  ClippedPolygon whole;
  for (const Eigen::Vector3d& corner : corners) whole.corners[static_cast<std::size_t>(whole.count++)] = corner;
  const double r = window.resolution_m;
  const std::int32_t y0 = std::max(window.low_y, window.cell(whole.low(1)));
  const std::int32_t y1 = std::min(window.high_y - 1, window.cell(whole.high(1)));
  for (std::int32_t y = y0; y <= y1; ++y) {
    const ClippedPolygon row = whole.cut(1, y * r, 1.0).cut(1, (y + 1) * r - kOpen_m, -1.0);
    if (row.count == 0) continue;
    const std::int32_t x0 = std::max(window.low_x, window.cell(row.low(0)));
    const std::int32_t x1 = std::min(window.high_x - 1, window.cell(row.high(0)));
    for (std::int32_t x = x0; x <= x1; ++x) {
      const ClippedPolygon cell = row.cut(0, x * r, 1.0).cut(0, (x + 1) * r - kOpen_m, -1.0);
      if (cell.count > 0) visit(x, y, cell.low(2), cell.high(2));
    }
  }
}

}  // namespace scanway::simulator
