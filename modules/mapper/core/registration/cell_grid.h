#pragma once

#include <algorithm>
#include <array>
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
    if (!reaches(query, radius)) return;
    for_each_run(query, radius, limit, [&](std::uint32_t begin, std::uint32_t end) {
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
  /// The nearest point within `radius` that `admit(position)` lets in; of equals, the lowest position. The position
  /// `hint` and the query's own cell are looked at first: what is found there spares most of the others.
  template <class Admit>
  Nearest nearest(const Eigen::Vector3f& query, float radius, const Admit& admit,
                  std::uint32_t hint = CellTable::kNone) const {
    Nearest best{CellTable::kNone, radius * radius};
    const auto look = [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) {
        const float d2 = (points_[i] - query).squaredNorm();
        if (d2 > best.squared_distance || (d2 == best.squared_distance && i >= best.position)) continue;
        if (admit(i)) best = {i, d2};
      }
      return true;
    };
    if (!reaches(query, radius)) return best;
    if (hint != CellTable::kNone) look(hint, hint + 1);
    look_at_home(query, look);
    for_each_run(query, radius, best.squared_distance, look);
    return best;
  }
  Nearest nearest(const Eigen::Vector3f& query, float radius) const {
    return nearest(query, radius, [](std::uint32_t) { return true; });
  }

  /// Whether any point within `radius` of `query` is one that `admit(position)` lets in.
  template <class Admit>
  bool any_within(const Eigen::Vector3f& query, float radius, const Admit& admit) const {
    if (!reaches(query, radius)) return false;
    const float limit = radius * radius;
    bool found = false;
    const auto look = [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end && !found; ++i) {
        found = (points_[i] - query).squaredNorm() <= limit && admit(i);
      }
      return !found;
    };
    if (look_at_home(query, look)) for_each_run(query, radius, limit, look);
    return found;
  }
  bool any_within(const Eigen::Vector3f& query, float radius) const {
    return any_within(query, radius, [](std::uint32_t) { return true; });
  }

 private:
  static constexpr float kRounding = 1e-6f;  ///< Of a coordinate: several times what the cells' bounds are off by.
  static constexpr std::int32_t kRowCells = 8;

  /// Cells that lie side by side along x, so that one look-up finds them all.
  struct Row {
    std::array<std::uint32_t, kRowCells + 1> begin;  ///< Of each cell its first position, and where the last one ends.
  };

  bool reaches(const Eigen::Vector3f& query, float radius) const {
    return !points_.empty() && query.array().abs().maxCoeff() + radius < reach_;
  }
  std::int32_t layer_of(float v) const { return floor_to_int(v * per_metre_); }
  static CellKey row_key(std::int32_t x, std::int32_t y, std::int32_t z) { return cell_key(x >> 3, y, z); }

  /// Calls run(begin, end) for the cells x0 to x1 at y, z, in rising order, until it returns false: so does this then.
  template <class Run>
  bool for_each_run_of(std::int32_t x0, std::int32_t x1, std::int32_t y, std::int32_t z, const Run& run) const {
    while (x0 <= x1) {
      const std::int32_t last = std::min(x1, x0 | (kRowCells - 1));
      const std::uint32_t row = rows_of_.find(row_key(x0, y, z));
      if (row != CellTable::kNone) {
        const std::uint32_t begin = rows_[row].begin[x0 & 7], end = rows_[row].begin[(last & 7) + 1];
        if (begin < end && !run(begin, end)) return false;
      }
      x0 = last + 1;
    }
    return true;
  }

  void enter_cell(std::uint32_t begin, std::uint32_t end);

  template <class Run>
  bool look_at_home(const Eigen::Vector3f& query, const Run& run) const {
    const std::int32_t x = layer_of(query.x());
    return for_each_run_of(x, x, layer_of(query.y()), layer_of(query.z()), run);
  }

  /// How far `v` lies from layer `cell` of the grid, squared: never more than from any point in it.
  float squared_gap(float v, std::int32_t cell) const {
    const float low = static_cast<float>(cell) * cell_m_, high = low + cell_m_;
    const float gap = std::max(0.0f, std::max(low - v, v - high) - kRounding * std::fabs(v));
    return gap * gap;
  }

  /// Calls run(begin, end) for the cells of the cube of `radius` about `query` that come within `squared_limit` of it
  /// (which may shrink meanwhile), in rising order, until it returns false.
  template <class Run>
  void for_each_run(const Eigen::Vector3f& query, float radius, const float& squared_limit, const Run& run) const {
    const std::int32_t low_x = layer_of(query.x() - radius), high_x = layer_of(query.x() + radius);
    const std::int32_t low_y = layer_of(query.y() - radius), high_y = layer_of(query.y() + radius);
    const std::int32_t low_z = layer_of(query.z() - radius), high_z = layer_of(query.z() + radius);
    for (std::int32_t z = low_z; z <= high_z; ++z) {
      const float gap_z = squared_gap(query.z(), z);
      for (std::int32_t y = low_y; y <= high_y; ++y) {
        const float gap = gap_z + squared_gap(query.y(), y);
        std::int32_t x0 = low_x, x1 = high_x;
        while (x0 <= x1 && gap + squared_gap(query.x(), x0) > squared_limit) ++x0;
        while (x0 <= x1 && gap + squared_gap(query.x(), x1) > squared_limit) --x1;
        if (!for_each_run_of(x0, x1, y, z, run)) return;
      }
    }
  }

  Points points_;
  std::vector<std::uint32_t> original_;
  std::vector<Row> rows_;
  CellTable rows_of_;  ///< From a row's key to its index in rows_.
  float cell_m_ = 1.0f, per_metre_ = 1.0f;
  float reach_ = 0.0f;  ///< Coordinates below this have a cell.
};

}  // namespace scanway::registration
