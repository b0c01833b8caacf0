#include "modules/mapper/core/registration/surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "modules/mapper/core/registration/eigen3.h"

namespace scanway::registration {
namespace {

constexpr int kLevels = 3;  // cells of 0.4, 0.8 and 1.6 m
constexpr std::uint32_t kMinPoints = 6;
constexpr double kMaxThickness = 0.08;  // deviation across the plane, in cells: 3 cm at the finest level
constexpr double kMinExtent = 0.12;     // deviation along its shorter axis, in cells

struct CellMoments {
  CellKey key = 0;
  Eigen::Vector3f centre;  ///< Of the cell: sums about it lose nothing in single precision.
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d outer = Eigen::Matrix3d::Zero();
  std::uint32_t count = 0;
};

std::vector<CellMoments> cell_moments(const Points& points, const std::vector<bool>& used, float cell_m) {
  std::vector<CellMoments> cells;
  CellTable table(points.size() / 8);
  std::uint32_t current = CellTable::kNone;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (used[i]) continue;
    const Eigen::Vector3f scaled = points[i] / cell_m;
    if (!(scaled.array().abs().maxCoeff() < static_cast<float>(kCellLimit - 1))) continue;
    const Eigen::Vector3i cell(floor_to_int(scaled.x()), floor_to_int(scaled.y()), floor_to_int(scaled.z()));
    const CellKey key = cell_key(cell.x(), cell.y(), cell.z());
    if (current == CellTable::kNone || cells[current].key != key) {
      const auto fresh = static_cast<std::uint32_t>(cells.size());
      current = table.find_or_insert(key, fresh);
      if (current == fresh) {
        cells.emplace_back();
        cells.back().key = key;
        cells.back().centre = (cell.cast<float>() + Eigen::Vector3f::Constant(0.5f)) * cell_m;
      }
    }
    const Eigen::Vector3d d = (points[i] - cells[current].centre).cast<double>();
    cells[current].sum += d;
    cells[current].outer += d * d.transpose();
    ++cells[current].count;
  }
  std::sort(cells.begin(), cells.end(), [](const CellMoments& a, const CellMoments& b) { return a.key < b.key; });
  return cells;
}

bool add_if_flat(const CellMoments& cell, float cell_m, Surfaces& surfaces) {
  if (cell.count < kMinPoints) return false;
  const Eigen::Vector3d mean = cell.sum / cell.count;
  const Eigen3 eigen = symmetric_eigen(cell.outer / cell.count - mean * mean.transpose());
  if (std::sqrt(std::max(0.0, eigen.values[0])) > kMaxThickness * cell_m) return false;
  if (!(std::sqrt(std::max(0.0, eigen.values[1])) > kMinExtent * cell_m)) return false;
  const Eigen::Vector3f centre = cell.centre + mean.cast<float>();
  const Eigen::Vector3f normal = eigen.vectors.col(0).cast<float>();
  surfaces.centre.push_back(centre);
  surfaces.normal.push_back(normal.dot(centre) > 0 ? Eigen::Vector3f(-normal) : normal);
  surfaces.variance.push_back(static_cast<float>(std::max(0.0, eigen.values[0]) / cell.count));
  surfaces.size.push_back(cell_m);
  return true;
}

/// Which of 3 x 3 patches of a cube's face (opposite faces as one) a direction points to.
std::size_t direction_bin(const Eigen::Vector3f& n) {
  int axis = 0;
  n.cwiseAbs().maxCoeff(&axis);
  const float u = n[(axis + 1) % 3] / n[axis], v = n[(axis + 2) % 3] / n[axis];
  const auto third = [](float w) { return std::clamp(static_cast<int>((w + 1.0f) * 1.5f), 0, 2); };
  return static_cast<std::size_t>(axis * 9 + third(u) * 3 + third(v));
}

/// Weights by the square root of how rare a direction is: the floor does not drown the walls, nor noise them.
void balance(Surfaces& surfaces) {
  std::array<double, 27> count{};
  for (const Eigen::Vector3f& n : surfaces.normal) count[direction_bin(n)] += 1.0;
  const double mean = static_cast<double>(surfaces.count()) / 27.0;
  surfaces.weight.resize(surfaces.count());
  double total = 0.0;
  for (std::size_t i = 0; i < surfaces.count(); ++i) {
    const double rarity = mean / count[direction_bin(surfaces.normal[i])];
    surfaces.weight[i] = static_cast<float>(std::min(3.0, std::sqrt(rarity)));
    total += surfaces.weight[i];
  }
  for (float& w : surfaces.weight) w *= static_cast<float>(static_cast<double>(surfaces.count()) / total);
}

}  // namespace

Surfaces choose_surfaces(const Points& points) {
  Surfaces surfaces;
  std::vector<bool> used(points.size(), false);
  float cell_m = kSurfaceCell;
  for (int level = 0; level < kLevels; ++level, cell_m *= 2.0f) {
    CellTable flat;
    for (const CellMoments& cell : cell_moments(points, used, cell_m)) {
      if (add_if_flat(cell, cell_m, surfaces)) flat.find_or_insert(cell.key, 1);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3f scaled = points[i] / cell_m;
      if (used[i] || !(scaled.array().abs().maxCoeff() < static_cast<float>(kCellLimit - 1))) continue;
      const CellKey key = cell_key(floor_to_int(scaled.x()), floor_to_int(scaled.y()), floor_to_int(scaled.z()));
      used[i] = flat.find(key) != CellTable::kNone;
    }
  }
  balance(surfaces);
  return surfaces;
}

Surfaces thin_surfaces(const Surfaces& surfaces, std::size_t count) {
  if (surfaces.count() <= count) return surfaces;
  double total = 0.0;
  for (const float w : surfaces.weight) total += w;
  const double step = total / static_cast<double>(count);
  Surfaces thin;
  double passed = 0.0, next = 0.5 * step;
  for (std::size_t i = 0; i < surfaces.count(); ++i) {
    passed += surfaces.weight[i];
    if (passed < next) continue;
    while (next <= passed) next += step;
    thin.centre.push_back(surfaces.centre[i]);
    thin.normal.push_back(surfaces.normal[i]);
    thin.variance.push_back(surfaces.variance[i]);
    thin.size.push_back(surfaces.size[i]);
    thin.weight.push_back(1.0f);
  }
  return thin;
}

}  // namespace scanway::registration
