#include "common/config/footprint.h"

#include <algorithm>
#include <cmath>

namespace scanway {
namespace {

using Corners = std::vector<Eigen::Vector2d>;

/// Twice the signed area of the triangle a, b, c; positive when it turns left.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool within_box(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) && std::min(a.y(), b.y()) <= p.y() &&
         p.y() <= std::max(a.y(), b.y());
}

/// Whether the closed segments ab and cd share a point.
bool segments_meet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                   const Eigen::Vector2d& d) {
  const double c_side = turn(a, b, c), d_side = turn(a, b, d), a_side = turn(c, d, a), b_side = turn(c, d, b);
  const auto opposite = [](double one, double other) { return (one > 0 && other < 0) || (one < 0 && other > 0); };
  if (opposite(c_side, d_side) && opposite(a_side, b_side)) return true;
  return (c_side == 0 && within_box(a, b, c)) || (d_side == 0 && within_box(a, b, d)) ||
         (a_side == 0 && within_box(c, d, a)) || (b_side == 0 && within_box(c, d, b));
}

bool folds_back(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return turn(a, b, c) == 0 && (b - a).dot(c - b) < 0;
}

bool intersects_itself(const Corners& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (folds_back(p[i], p[(i + 1) % n], p[(i + 2) % n])) return true;
    for (std::size_t j = i + 2; j < n; ++j) {
      const bool neighbours = (j + 1) % n == i;
      if (!neighbours && segments_meet(p[i], p[i + 1], p[j], p[(j + 1) % n])) return true;
    }
  }
  return false;
}

double doubled_area(const Corners& p) {
  double area = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Eigen::Vector2d& a = p[i];
    const Eigen::Vector2d& b = p[(i + 1) % p.size()];
    area += a.x() * b.y() - b.x() * a.y();
  }
  return area;
}

/// Whether the origin lies inside the simple polygon, not on its edge: by the parity of the edges that cross the
/// half-line from the origin along +x.
bool contains_centre(const Corners& p) {
  const Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  bool inside = false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Eigen::Vector2d& a = p[i];
    const Eigen::Vector2d& b = p[(i + 1) % p.size()];
    const double side = turn(a, b, centre);
    if (side == 0 && within_box(a, b, centre)) return false;
    if ((a.y() > 0) != (b.y() > 0) && (side > 0) == (b.y() > a.y())) inside = !inside;
  }
  return inside;
}

}  // namespace

std::string footprint_problem(const Corners& corners) {
  if (corners.size() < 3) return "has fewer than 3 corners";
  if (corners.size() > 256) return "has more than 256 corners";
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!(corners[i].cwiseAbs().maxCoeff() <= 100.0)) return "has a corner farther than 100 m from the centre";
    if (corners[i] == corners[(i + 1) % corners.size()]) return "has the same corner twice in a row";
  }
  if (intersects_itself(corners)) return "crosses or touches itself: list the corners in order around the body";
  if (doubled_area(corners) < 0) return "runs clockwise: list the corners counter-clockwise";
  if (!contains_centre(corners)) return "does not have the robot's centre [0, 0] inside";
  return "";
}

}  // namespace scanway
