#include "modules/planner/core/explain/obstruction.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <vector>

#include "modules/planner/core/explain/area.h"

namespace scanway::planning {
namespace {

/// Squared distances in cells; large enough for every map, small enough to be added to.
constexpr std::int64_t kFar = std::int64_t{1} << 40;

template <class Blocks>
bool reaches(const Area& area, Cell start, Cell goal, const Blocks& blocks) {
  bool reached = false;
  for_reached(area, start, blocks, [&](Cell cell) {
    reached = reached || cell == goal;
    return !reached;
  });
  return reached;
}

/// One dimension of the distance transform: out[i] = min over j of (i - j)^2 + in[j] (Felzenszwalb and Huttenlocher,
/// Theory of Computing 2012).
void transform_line(std::vector<std::int64_t>& line) {
  const std::vector<std::int64_t> in = line;
  const auto size = static_cast<std::int64_t>(in.size());
  const auto value = [&in](std::int64_t i) { return in[static_cast<std::size_t>(i)]; };
  std::vector<std::int64_t> parabolas;
  std::vector<double> from;
  for (std::int64_t i = 0; i < size; ++i) {
    double meet = -1.0;
    while (!parabolas.empty()) {
      const std::int64_t j = parabolas.back();
      meet = static_cast<double>(value(i) + i * i - value(j) - j * j) / static_cast<double>(2 * (i - j));
      if (meet > from.back()) break;
      parabolas.pop_back();
      from.pop_back();
    }
    from.push_back(parabolas.empty() ? -1.0 : meet);
    parabolas.push_back(i);
  }
  std::size_t k = 0;
  for (std::int64_t i = 0; i < size; ++i) {
    while (k + 1 < parabolas.size() && from[k + 1] < static_cast<double>(i)) ++k;
    line[static_cast<std::size_t>(i)] = (i - parabolas[k]) * (i - parabolas[k]) + value(parabolas[k]);
  }
}

/// For every cell the squared distance to the nearest cell that blocks, middle to middle.
std::vector<std::int64_t> distances(const Area& area, const Terrain& terrain) {
  std::vector<std::int64_t> result(area.size());
  const auto width = static_cast<std::size_t>(area.bounds().width());
  const auto height = static_cast<std::size_t>(area.bounds().height());
  std::vector<std::int64_t> line(width);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) line[x] = terrain.blocks(area.cell(y * width + x)) ? 0 : kFar;
    transform_line(line);
    std::copy(line.begin(), line.end(), result.begin() + static_cast<std::ptrdiff_t>(y * width));
  }
  line.resize(height);
  for (std::size_t x = 0; x < width; ++x) {
    for (std::size_t y = 0; y < height; ++y) line[y] = result[y * width + x];
    transform_line(line);
    for (std::size_t y = 0; y < height; ++y) result[y * width + x] = line[y];
  }
  return result;
}

/// The place where the way that keeps furthest from what blocks comes nearest to it.
Cell bottleneck(const Area& area, Cell start, Cell goal, const std::vector<std::int64_t>& distance,
                const Terrain& terrain) {
  using Entry =
      std::tuple<std::int64_t, std::int64_t, std::size_t, std::size_t>;  // room so far, room here, cell, worst
  std::priority_queue<Entry> queue;
  std::vector<bool> seen(area.size());
  const auto blocks = [&](Cell cell) { return !area.contains(cell) || terrain.blocks(cell); };
  const std::size_t first = area.index(start);
  queue.emplace(distance[first], distance[first], first, first);
  seen[first] = true;
  while (!queue.empty()) {
    const auto [room, here, index, worst] = queue.top();
    queue.pop();
    if (area.cell(index) == goal) return area.cell(worst);
    for (int step = 0; step < kSteps; ++step) {
      const auto next = step_from(area.cell(index), step, blocks);
      if (!next || seen[area.index(*next)]) continue;
      const std::size_t at = area.index(*next);
      seen[at] = true;
      queue.emplace(std::min(room, distance[at]), distance[at], at, distance[at] < room ? at : worst);
    }
  }
  return start;
}

/// From the nearest cell that blocks, through `cell`, to what blocks on the other side.
double width_at(const Area& area, Cell cell, std::int64_t distance2, const Terrain& terrain) {
  const double distance = std::sqrt(static_cast<double>(distance2));
  const auto reach = static_cast<std::int32_t>(std::ceil(distance));
  Cell nearest = cell;
  for (std::int32_t y = -reach; y <= reach; ++y) {
    for (std::int32_t x = -reach; x <= reach; ++x) {
      const Cell there = {cell.x + x, cell.y + y};
      if (x * x + y * y == distance2 && terrain.blocks(there)) nearest = there;
    }
  }
  const double dx = (cell.x - nearest.x) / distance;
  const double dy = (cell.y - nearest.y) / distance;
  double other = 0.0;
  for (Cell there = cell; area.contains(there) && !terrain.blocks(there); other += 1.0) {
    there = {cell.x + static_cast<std::int32_t>(std::floor(dx * (other + 1.0) + 0.5)),
             cell.y + static_cast<std::int32_t>(std::floor(dy * (other + 1.0) + 0.5))};
  }
  return distance + other - 1.0;
}

}  // namespace

Obstruction find_obstruction(const Terrain& terrain, Cell start, Cell goal) {
  const Area area(terrain.bounds());
  const auto occupied = [&](Cell cell) { return !area.contains(cell) || terrain.is_occupied(cell); };
  const auto blocks = [&](Cell cell) { return !area.contains(cell) || terrain.blocks(cell); };
  if (!reaches(area, start, goal, occupied)) return {Obstruction::Kind::walled_in, {}};
  if (!reaches(area, start, goal, blocks)) return {Obstruction::Kind::only_through_unknown, {}};
  const std::vector<std::int64_t> distance = distances(area, terrain);
  const Cell worst = bottleneck(area, start, goal, distance, terrain);
  return {Obstruction::Kind::too_narrow, worst, width_at(area, worst, distance[area.index(worst)], terrain)};
}

}  // namespace scanway::planning
