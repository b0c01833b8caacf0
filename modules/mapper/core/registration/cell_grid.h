#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "modules/mapper/core/registration/cell_table.h"
#include "modules/mapper/core/registration/points.h"

namespace scanway::registration {

/// Neighbour search among points: a hash grid over points that are stored cell by cell, so that a query reads a few
/// contiguous runs. Immutable.
class CellGrid {
 public:
  CellGrid() = default;
  /// `cell_m`: about the radius of the searches to come.
  CellGrid(const Points& points, float cell_m);

  /// The points in the grid's own order; neighbours are positions in it.
  const Points& points() const { return points_; }
  /// For each position, the index of the point in the array that the grid was made from.
  const std::vector<std::uint32_t>& original() const { return original_; }
  std::size_t size() const { return points_.size(); }

  /// Calls visit(position, squared distance) for every point within `radius` of `query`, in rising order of position.
  template <class Visit>
  void for_each_within(const Eigen::Vector3f& query, float radius, const Visit& visit) const {
    const float limit = radius * radius;
    for_each_run(query, radius, [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) {
        const float d2 = (points_[i] - query).squaredNorm();
        if (d2 <= limit) visit(i, d2);
      }
      return true;
    });
  }

  /// Runs of positions that together hold everything within `radius` of any point of the cell of `position`, in rising
  /// order: found once, they serve all points of that cell, which end at the returned position.
  std::uint32_t runs_about_cell(std::uint32_t position, float radius,
                                std::vector<std::pair<std::uint32_t, std::uint32_t>>& runs) const;

  struct Nearest {
    std::uint32_t position = CellTable::kNone;  ///< kNone: nothing within the radius.
    float squared_distance = std::numeric_limits<float>::max();
    bool found() const { return position != CellTable::kNone; }
  };
  /// The nearest point within `radius` that `admit(position)` lets in; of equals, the lowest position. The query's own
  /// cell is looked at first: what is found there spares most of the others.
  template <class Admit>
  Nearest nearest(const Eigen::Vector3f& query, float radius, const Admit& admit) const {
    Nearest best{CellTable::kNone, radius * radius};
    const auto look = [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) {
        const float d2 = (points_[i] - query).squaredNorm();
        if (d2 > best.squared_distance || (d2 == best.squared_distance && i >= best.position)) continue;
        if (admit(i)) best = {i, d2};
      }
    };
    if (points_.empty() || !(query.array().abs().maxCoeff() + radius < reach_)) return best;
    const std::uint32_t home = cell_of(query);
    if (home != CellTable::kNone) look(begin_[home], begin_[home + 1]);
    for_each_cell(query, radius, best.squared_distance, [&](std::uint32_t cell) {
      if (cell != home) look(begin_[cell], begin_[cell + 1]);
      return true;
    });
    return best;
  }
  Nearest nearest(const Eigen::Vector3f& query, float radius) const {
    return nearest(query, radius, [](std::uint32_t) { return true; });
  }

  /// Whether any point lies within `radius` of `query`.
  bool any_within(const Eigen::Vector3f& query, float radius) const;

 private:
  static constexpr float kRounding = 1e-6f;  ///< Of a coordinate: several times what the cells' bounds are off by.

  /// Calls run(begin, end) for runs of positions that together hold everything within `radius`, in rising order,
  /// until it returns false.
  template <class Run>
  void for_each_run(const Eigen::Vector3f& query, float radius, const Run& run) const {
    if (points_.empty() || !(query.array().abs().maxCoeff() + radius < reach_)) return;
    for_each_cell(query, radius, radius * radius,
                  [&](std::uint32_t cell) { return run(begin_[cell], begin_[cell + 1]); });
  }

  std::uint32_t cell_of(const Eigen::Vector3f& p) const {
    const auto at = [&](float v) { return floor_to_int(v * per_metre_); };
    return table_.find(cell_key(at(p.x()), at(p.y()), at(p.z())));
  }

  /// How far `v` lies from layer `cell` of the grid, squared: never more than from any point in it.
  float squared_gap(float v, std::int32_t cell) const {
    const float low = static_cast<float>(cell) * cell_m_, high = low + cell_m_;
    const float gap = std::max(0.0f, std::max(low - v, v - high) - kRounding * std::fabs(v));
    return gap * gap;
  }

  /// Calls visit(cell) for the cells of the cube of `radius` about `query` that come within `squared_limit` of it
  /// (which may shrink meanwhile), in rising order, until it returns false.
  template <class Visit>
  void for_each_cell(const Eigen::Vector3f& query, float radius, const float& squared_limit, const Visit& visit) const {
    const auto low = [&](float v) { return floor_to_int((v - radius) * per_metre_); };
    const auto high = [&](float v) { return floor_to_int((v + radius) * per_metre_); };
    const std::int32_t x0 = low(query.x()), x1 = high(query.x());
    for (std::int32_t z = low(query.z()); z <= high(query.z()); ++z) {
      const float gap_z = squared_gap(query.z(), z);
      for (std::int32_t y = low(query.y()); y <= high(query.y()); ++y) {
        const float gap_yz = gap_z + squared_gap(query.y(), y);
        if (gap_yz > squared_limit) continue;
        for (std::int32_t x = x0; x <= x1; ++x) {
          if (gap_yz + squared_gap(query.x(), x) > squared_limit) continue;
          const std::uint32_t cell = table_.find(cell_key(x, y, z));
          if (cell != CellTable::kNone && !visit(cell)) return;
        }
      }
    }
  }

  Points points_;
  std::vector<std::uint32_t> original_;
  std::vector<std::uint32_t> begin_;  ///< For each cell its first position; one more at the end.
  CellTable table_;                   ///< From a cell's key to its index in begin_.
  float cell_m_ = 1.0f, per_metre_ = 1.0f;
  float reach_ = 0.0f;  ///< Coordinates below this have a cell.
};

}  // namespace scanway::registration
