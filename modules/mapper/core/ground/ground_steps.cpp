#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "modules/mapper/core/ground/ground_surface.h"

/// Where the ground goes up or down by a step within a column or beside it.
namespace scanway {
namespace {

constexpr int kFirmPoints = 4;          // a column's mean of fewer is as uneven as the ground itself
constexpr int kOnLevel = 8;             // a column that is off a level by less than this part of a step lies on it
constexpr int kFaceRange = 1000;        // units about a column's mean: what is further off is no part of the ground
constexpr std::int32_t kFaceRatio = 3;  // a face spreads over so many times as much as the ground around it
constexpr int kAround = 6;              // columns: what a face is told from
constexpr int kEdgePoints = 2;          // below a column's ground show that it ends in the column

}  // namespace

const GroundSurface::Column* GroundSurface::firm(int cx, int cy) const {
  if (!inside(cx, cy)) return nullptr;
  const Column& column = columns_[index(cx, cy)];
  return column.joined && column.count >= kFirmPoints ? &column : nullptr;
}

void GroundSurface::find_step(int cx, int cy, int dx, int dy) {
  const Column *before = firm(cx - dx, cy - dy), *after = firm(cx + dx, cy + dy);
  if (before == nullptr || after == nullptr || before->face || after->face) return;
  const std::int32_t low = mean(index(cx - dx, cy - dy)), high = mean(index(cx + dx, cy + dy));
  std::int32_t jump = high - low;
  if (std::abs(jump) <= band_) return;
  if (firm(cx, cy) != nullptr) {  // On one of the two levels: the step runs beside it.
    const std::int32_t here = mean(index(cx, cy));
    if (std::min(std::abs(here - low), std::abs(here - high)) < std::abs(jump) / kOnLevel) return;
  }
  for (const int side : {-1, 1}) {
    for (const int far : {3, 2}) {
      if (firm(cx + side * far * dx, cy + side * far * dy) == nullptr) continue;
      const std::int32_t beyond = mean(index(cx + side * far * dx, cy + side * far * dy));
      jump -= side * (beyond - (side < 0 ? low : high)) / (far - 1);
      break;
    }
  }
  if (std::abs(jump) <= band_) return;
  Column& column = columns_[index(cx, cy)];
  const std::int32_t lower = std::min(low, high);
  column.lower = column.step ? std::min(column.lower, lower) : lower;
  column.step = true;
}

std::int32_t GroundSurface::lowest_around(int cx, int cy) const {
  std::int32_t lowest = mean(index(cx, cy));
  for (int y = std::max(cy - kReach, 0); y <= std::min(cy + kReach, side_ - 1); ++y) {
    for (int x = std::max(cx - kReach, 0); x <= std::min(cx + kReach, side_ - 1); ++x) {
      if (columns_[index(x, y)].joined) lowest = std::min(lowest, mean(index(x, y)));
    }
  }
  return lowest;
}

void GroundSurface::find_edge(int cx, int cy) {
  const std::size_t which = index(cx, cy);
  Column& column = columns_[which];
  const std::int32_t high = mean(which) - band_;
  const auto count_between = [&](std::int32_t low) {
    const auto begin = points_.begin() + static_cast<std::ptrdiff_t>(first_[which]);
    const auto end = points_.begin() + static_cast<std::ptrdiff_t>(first_[which + 1]);
    return std::count_if(begin, end, [&](const Point& point) { return point.u < high && point.u > low; });
  };
  if (count_between(std::numeric_limits<std::int32_t>::min()) < kEdgePoints) return;
  const std::int32_t lower = lowest_around(cx, cy);
  if (lower >= high || count_between(lower - band_) < kEdgePoints) return;
  column.lower = column.step ? std::min(column.lower, lower) : lower;
  column.step = true;
}

void GroundSurface::find_steps() {
  for (int cy = 0; cy < side_; ++cy) {
    for (int cx = 0; cx < side_; ++cx) {
      for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1), std::pair(1, -1)}) {
        find_step(cx, cy, dx, dy);
      }
      if (columns_[index(cx, cy)].joined) find_edge(cx, cy);
    }
  }
}

void GroundSurface::measure_spread(std::size_t which) {
  Column& column = columns_[which];
  const std::int32_t middle = mean(which);
  std::int64_t count = 0, sum = 0, squares = 0;
  column.lowest = middle;
  for (std::size_t i = first_[which]; i < first_[which + 1]; ++i) {
    const std::int64_t off = points_[i].u - middle;
    if (std::abs(off) > kFaceRange) continue;
    ++count, sum += off, squares += off * off;
    column.lowest = std::min(column.lowest, points_[i].u);
  }
  const double n = static_cast<double>(std::max<std::int64_t>(count, 1));
  const double average = static_cast<double>(sum) / n;
  column.spread =
      static_cast<std::int32_t>(std::sqrt(std::max(0.0, static_cast<double>(squares) / n - average * average)));
}

void GroundSurface::find_face(int cx, int cy) {
  Column& column = columns_[index(cx, cy)];
  // Evenly spread over a height h, the deviation is h / sqrt(12).
  if (column.step || column.count < kFirmPoints || column.spread * 12 < band_ * 4) return;
  std::vector<std::int32_t> around;
  std::int32_t lowest = column.lowest;
  for (int y = -kAround; y <= kAround; ++y) {
    for (int x = -kAround; x <= kAround; ++x) {
      const Column* other = firm(cx + x, cy + y);
      if (other == nullptr) continue;
      around.push_back(other->spread);
      if (std::abs(x) <= 1 && std::abs(y) <= 1) lowest = std::min(lowest, other->lowest);
    }
  }
  // The face goes on to both sides, so that many of the columns around show it, too.
  const auto even = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 5);
  std::nth_element(around.begin(), even, around.end());
  if (column.spread < kFaceRatio * *even) return;
  column.face = column.step = true;
  column.lower = lowest;
}

void GroundSurface::find_faces() {
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if (columns_[column].joined) measure_spread(column);
  }
  for (int cy = 0; cy < side_; ++cy) {
    for (int cx = 0; cx < side_; ++cx) {
      if (columns_[index(cx, cy)].joined) find_face(cx, cy);
    }
  }
}

bool GroundSurface::stepped_between(int cx, int cy, int x, int y) const {
  const int steps = std::max(std::abs(x - cx), std::abs(y - cy));
  for (int i = 1; i < steps; ++i) {
    const auto between = [&](int from, int to) {
      return from + static_cast<int>(std::lround(double(to - from) * i / steps));
    };
    if (columns_[index(between(cx, x), between(cy, y))].step) return true;
  }
  return false;
}

}  // namespace scanway
