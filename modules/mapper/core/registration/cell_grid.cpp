#include "modules/mapper/core/registration/cell_grid.h"

#include <algorithm>
#include <cstdlib>
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

std::uint32_t CellGrid::runs_about_cell(std::uint32_t position, float radius,
                                        std::vector<std::pair<std::uint32_t, std::uint32_t>>& runs) const {
  const auto at = [&](float v) { return floor_to_int(v * per_metre_); };
  const Eigen::Vector3i home(at(points_[position].x()), at(points_[position].y()), at(points_[position].z()));
  const std::int32_t reach = floor_to_int(radius * per_metre_ * 1.0001f) + 1;
  const auto gap2 = [&](std::int32_t cells) {  // between two layers of cells that many apart
    const float gap = cell_m_ * static_cast<float>(std::max(0, std::abs(cells) - 1)) * 0.9999f;
    return gap * gap;
  };
  runs.clear();
  for (std::int32_t z = -reach; z <= reach; ++z) {
    for (std::int32_t y = -reach; y <= reach; ++y) {
      for (std::int32_t x = -reach; x <= reach; ++x) {
        if (gap2(x) + gap2(y) + gap2(z) > radius * radius) continue;
        const std::uint32_t cell = table_.find(cell_key(home.x() + x, home.y() + y, home.z() + z));
        if (cell != CellTable::kNone) runs.emplace_back(begin_[cell], begin_[cell + 1]);
      }
    }
  }
  return begin_[table_.find(cell_key(home.x(), home.y(), home.z())) + 1];
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
