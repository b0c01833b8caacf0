#include "modules/mapper/core/ground/ground_patches.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/LU>

#include "modules/mapper/core/cloud/radix_sort.h"

namespace scanway {
namespace {

struct Return {
  std::uint64_t key;  ///< Its patch.
  std::uint32_t point;
  bool higher;  ///< Than grass: from what stands there.
};

constexpr double kStanding = 0.5;    // metres above the ground: so far something that stands on it is looked for
constexpr double kMostHigher = 0.1;  // of a patch's returns
constexpr std::int64_t kMiddle = 1 << 20;

std::uint64_t key_of(Cell place) {
  return static_cast<std::uint64_t>(place.y + kMiddle) << 21 | static_cast<std::uint64_t>(place.x + kMiddle);
}

/// Those at the ground and up to half a metre over it, by patch; within one as they were taken.
std::vector<Return> returns_by_patch(const MapPoints& points, const GroundSurface& ground) {
  std::vector<Return> returns;
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const Eigen::Vector3f& p = points.points[i];
    const GroundSurface::Place place = ground.at(p.x(), p.y());
    const double above = p.z() - place.height;
    if (!place.carried || above < -GroundPatches::kGrass_m || above > kStanding) continue;
    returns.push_back({key_of(GroundPatches::place_of(p.x(), p.y())), static_cast<std::uint32_t>(i),
                       above > GroundPatches::kGrass_m});
  }
  radix_sort_by_key(returns);
  return returns;
}

/// z = a x + b y + c by least squares, about a point near by.
struct Plane {
  Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();
  bool found = false;

  double residual(const Eigen::Vector3d& p) const {
    return p.z() - (coefficients[0] * p.x() + coefficients[1] * p.y() + coefficients[2]);
  }
};

constexpr double kPatchShrinkage = 1e-4;  // m^2 a point: points on one line carry no slope across it

Plane fit(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d row(p.x(), p.y(), 1.0);
    H += row * row.transpose();
    g += p.z() * row;
  }
  H(0, 0) += kPatchShrinkage * static_cast<double>(points.size());
  H(1, 1) += kPatchShrinkage * static_cast<double>(points.size());
  if (!(std::fabs(H.determinant()) > 1e-9)) return {};
  return {H.inverse() * g, true};
}

/// Of the surface around p, as even as it is within half a metre: the plane of a patch's own few returns is not.
Eigen::Vector3d normal_at(const GroundSurface& ground, const Eigen::Vector3d& p) {
  constexpr double kAside = 0.25;
  const double dx = ground.height_at(p.x() + kAside, p.y()) - ground.height_at(p.x() - kAside, p.y());
  const double dy = ground.height_at(p.x(), p.y() + kAside) - ground.height_at(p.x(), p.y() - kAside);
  return Eigen::Vector3d(-dx, -dy, 2 * kAside) / std::sqrt(dx * dx + dy * dy + 4 * kAside * kAside);
}

/// Too few returns, or some of something that stands there, whose foot is no ground.
bool tells_nothing(const Return* begin, const Return* end) {
  const auto higher = std::count_if(begin, end, [](const Return& r) { return r.higher; });
  return end - begin - higher < GroundPatches::kFewest ||
         static_cast<double>(higher) > kMostHigher * static_cast<double>(end - begin);
}

GroundPatch measure(const MapPoints& points, const GroundSurface& ground, const Return* begin, const Return* end) {
  GroundPatch patch;
  const Eigen::Vector3d first = points.points[begin->point].cast<double>();
  std::vector<Eigen::Vector3d> around;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Return* r = begin; r != end; ++r) {
    if (r->higher) continue;
    around.push_back(points.points[r->point].cast<double>() - first);
    middle += around.back();
    patch.intensity += points.intensity[r->point];
  }
  const double n = static_cast<double>(around.size());
  const Plane plane = fit(around);
  middle = first + middle / n;
  const Eigen::Vector3d beam = middle - points.origin, normal = normal_at(ground, middle);
  patch.range_m = beam.norm();
  patch.intensity /= n;
  patch.cosine = std::fabs(normal.dot(beam)) / patch.range_m;
  if (!plane.found || patch.cosine < GroundPatches::kFlattest) return {};
  double squares = 0.0;
  for (const Eigen::Vector3d& p : around) squares += plane.residual(p) * plane.residual(p);
  patch.roughness_m = std::sqrt(squares / (n - 3.0)) * normal.z() / patch.cosine;
  patch.points = static_cast<int>(around.size());
  return patch;
}

}  // namespace

Cell GroundPatches::place_of(double x, double y) {
  return {static_cast<std::int32_t>(std::floor(x / kSide)), static_cast<std::int32_t>(std::floor(y / kSide))};
}

GroundPatches::GroundPatches(const MapPoints& points, const GroundSurface& ground) {
  if (points.intensity.size() != points.points.size()) return;
  const std::vector<Return> returns = returns_by_patch(points, ground);
  for (std::size_t begin = 0, end = 0; begin < returns.size(); begin = end) {
    for (end = begin + 1; end < returns.size() && returns[end].key == returns[begin].key;) ++end;
    if (tells_nothing(&returns[begin], returns.data() + end)) continue;
    const GroundPatch patch = measure(points, ground, &returns[begin], returns.data() + end);
    if (patch.points == 0) continue;
    const Eigen::Vector3f& p = points.points[returns[begin].point];
    patches_.emplace(place_of(p.x(), p.y()), patch);
  }
}

}  // namespace scanway
