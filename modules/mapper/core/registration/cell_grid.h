#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

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

  struct Nearest {
    std::uint32_t position = CellTable::kNone;  ///< kNone: nothing within the radius.
    float squared_distance = std::numeric_limits<float>::max();
    bool found() const { return position != CellTable::kNone; }
  };
  /// The nearest point within `radius` that `admit(position)` lets in; of equals, the lowest position.
  template <class Admit>
  Nearest nearest(const Eigen::Vector3f& query, float radius, const Admit& admit) const {
    Nearest best{CellTable::kNone, radius * radius};
    for_each_run(query, radius, [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) {
        const float d2 = (points_[i] - query).squaredNorm();
        if ((d2 < best.squared_distance || (!best.found() && d2 == best.squared_distance)) && admit(i)) best = {i, d2};
      }
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
  /// Calls run(begin, end) for runs of positions that together hold everything within `radius`, in rising order,
  /// until it returns false.
  template <class Run>
  void for_each_run(const Eigen::Vector3f& query, float radius, const Run& run) const {
    if (points_.empty() || !(query.array().abs().maxCoeff() + radius < reach_)) return;
    const auto low = [&](float v) { return floor_to_int((v - radius) * per_metre_); };
    const auto high = [&](float v) { return floor_to_int((v + radius) * per_metre_); };
    const std::int32_t x0 = low(query.x()), x1 = high(query.x());
    for (std::int32_t z = low(query.z()); z <= high(query.z()); ++z) {
      for (std::int32_t y = low(query.y()); y <= high(query.y()); ++y) {
        for (std::int32_t x = x0; x <= x1; ++x) {
          const std::uint32_t cell = table_.find(cell_key(x, y, z));
          if (cell != CellTable::kNone && !run(begin_[cell], begin_[cell + 1])) return;
        }
      }
    }
  }

  Points points_;
  std::vector<std::uint32_t> original_;
  std::vector<std::uint32_t> begin_;  ///< For each cell its first position; one more at the end.
  CellTable table_;                   ///< From a cell's key to its index in begin_.
  float per_metre_ = 1.0f;
  float reach_ = 0.0f;  ///< Coordinates below this have a cell.
};

}  // namespace scanway::registration
