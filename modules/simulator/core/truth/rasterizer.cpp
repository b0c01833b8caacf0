#include "modules/simulator/core/truth/rasterizer.h"

#include <utility>

namespace scanway::simulator {
namespace {

using Eigen::Vector3d;

constexpr double kUpright = 1e-12;  // Square metres of the triangle's shadow.

/// Twice the area of (a, b, p), positive to the left of a -> b; the same bits, but for the sign, for b -> a.
double side_of(const Vector3d& a, const Vector3d& b, double x, double y) {
  const bool swap = std::pair(b.x(), b.y()) < std::pair(a.x(), a.y());
  const Vector3d &p = swap ? b : a, &q = swap ? a : b;
  const double area = (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x());
  return swap ? -area : area;
}

/// Whether points on the edge a -> b belong to the triangle on its left; never true for b -> a as well.
bool owns_edge(const Vector3d& a, const Vector3d& b) { return b.y() < a.y() || (b.y() == a.y() && b.x() < a.x()); }

}  // namespace

FlatTriangle::FlatTriangle(const Corners& corners)
    : corners_(corners),
      low_(corners[0].cwiseMin(corners[1]).cwiseMin(corners[2])),
      high_(corners[0].cwiseMax(corners[1]).cwiseMax(corners[2])) {
  const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  if (std::fabs(normal.z()) < kUpright) return;
  facing_ = normal.z() > 0 ? 1 : -1;
  slope_x_ = -normal.x() / normal.z();
  slope_y_ = -normal.y() / normal.z();
  if (facing_ < 0) std::swap(corners_[1], corners_[2]);
}

bool FlatTriangle::covers(double x, double y) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d &a = corners_[i], &b = corners_[(i + 1) % 3];
    const double side = side_of(a, b, x, y);
    if (side < 0 || (side == 0 && !owns_edge(a, b))) return false;
  }
  return true;
}

}  // namespace scanway::simulator
