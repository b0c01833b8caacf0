#include "modules/mapper/core/registration/cell_grid.h"

#include <algorithm>
#include <utility>

namespace scanway::registration {

CellGrid::CellGrid(const Points& points, float cell_m)
    : cell_m_(cell_m), per_metre_(1.0f / cell_m), reach_(cell_m * static_cast<float>(kCellLimit - 2)) {
  std::vector<std::pair<CellKey, std::uint32_t>> order;
  order.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!(points[i].array().abs().maxCoeff() < reach_)) continue;
    const Eigen::Vector3f scaled = points[i] * per_metre_;
    order.emplace_back(cell_key(floor_to_int(scaled.x()), floor_to_int(scaled.y()), floor_to_int(scaled.z())), i);
  }
  std::sort(order.begin(), order.end());
  points_.reserve(order.size());
  original_.reserve(order.size());
  table_ = CellTable(order.size() / 4);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || order[i].first != order[i - 1].first) {
      table_.find_or_insert(order[i].first, static_cast<std::uint32_t>(begin_.size()));
      begin_.push_back(static_cast<std::uint32_t>(i));
    }
    points_.push_back(points[order[i].second]);
    original_.push_back(order[i].second);
  }
  begin_.push_back(static_cast<std::uint32_t>(order.size()));
}

bool CellGrid::any_within(const Eigen::Vector3f& query, float radius) const {
  bool found = false;
  const float limit = radius * radius;
  for_each_run(query, radius, [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end && !found; ++i) found = (points_[i] - query).squaredNorm() <= limit;
    return !found;
  });
  return found;
}

}  // namespace scanway::registration
