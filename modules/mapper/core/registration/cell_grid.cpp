#include "modules/mapper/core/registration/cell_grid.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "modules/mapper/core/registration/cell_order.h"

namespace scanway::registration {

CellGrid::CellGrid(const Points& points, float cell_m)
    : cell_m_(cell_m), per_metre_(1.0f / cell_m), reach_(cell_m * static_cast<float>(kCellLimit - 2)) {
  std::vector<KeyedIndex> order;
  order.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!(points[i].array().abs().maxCoeff() < reach_)) continue;
    const Eigen::Vector3f& p = points[i];
    order.push_back({cell_key(layer_of(p.x()), layer_of(p.y()), layer_of(p.z())), i});
  }
  sort_by_cell(order);
  points_.reserve(order.size());
  original_.reserve(order.size());
  rows_of_ = CellTable(order.size() / 8);
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    for (; end < order.size() && order[end].key == order[begin].key; ++end) {
      points_.push_back(points[order[end].index]);
      original_.push_back(order[end].index);
    }
    enter_cell(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
  }
}

/// That the positions [begin, end) are all that lie in one cell; cells come in rising order.
void CellGrid::enter_cell(std::uint32_t begin, std::uint32_t end) {
  const Eigen::Vector3f& p = points_[begin];
  const std::int32_t x = layer_of(p.x());
  const auto fresh = static_cast<std::uint32_t>(rows_.size());
  const std::uint32_t row = rows_of_.find_or_insert(row_key(x, layer_of(p.y()), layer_of(p.z())), fresh);
  if (row == fresh) rows_.emplace_back().begin.fill(begin);
  std::fill(rows_[row].begin.begin() + (x & 7) + 1, rows_[row].begin.end(), end);
}

std::uint32_t CellGrid::runs_about_cell(std::uint32_t position, float radius,
                                        std::vector<std::pair<std::uint32_t, std::uint32_t>>& runs) const {
  const Eigen::Vector3f& p = points_[position];
  const Eigen::Vector3i home(layer_of(p.x()), layer_of(p.y()), layer_of(p.z()));
  const std::int32_t reach = floor_to_int(radius * per_metre_ * 1.0001f) + 1;
  const auto gap2 = [&](std::int32_t cells) {  // between two layers of cells that many apart
    const float gap = cell_m_ * static_cast<float>(std::max(0, std::abs(cells) - 1)) * 0.9999f;
    return gap * gap;
  };
  runs.clear();
  for (std::int32_t z = -reach; z <= reach; ++z) {
    for (std::int32_t y = -reach; y <= reach; ++y) {
      std::int32_t x = reach;
      while (x >= 0 && gap2(x) + gap2(y) + gap2(z) > radius * radius) --x;
      for_each_run_of(home.x() - x, home.x() + x, home.y() + y, home.z() + z,
                      [&](std::uint32_t begin, std::uint32_t end) {
                        runs.emplace_back(begin, end);
                        return true;
                      });
    }
  }
  const Row& row = rows_[rows_of_.find(row_key(home.x(), home.y(), home.z()))];
  return row.begin[(home.x() & 7) + 1];
}

}  // namespace scanway::registration
