#include "tests/modules/planner/support/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>

#include "tests/modules/planner/support/polygon_check.h"

namespace scanway::test {
namespace {

constexpr std::array<Cell, 8> kAround = {Cell{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
constexpr double kStraight = 5741.0;
constexpr double kDiagonal = 8119.0;

bool blocks(const TestMap& map, const Robot& robot, Cell cell) {
  const CellState state = map.bounds.contains(cell) ? map.map.state(cell) : CellState::unknown;
  return state == CellState::occupied ||
         (state == CellState::unknown && robot.planning.unknown == UnknownPolicy::never);
}

/// In 64ths of a metre's price.
double weight(const TestMap& map, const Robot& robot, planning::BodyMode mode, Cell cell) {
  double weight = 64.0;
  if (map.map.state(cell) == CellState::unknown && robot.planning.unknown == UnknownPolicy::price) {
    weight += std::floor(64.0 * robot.planning.unknown_price + 0.5);
  }
  if (mode != planning::BodyMode::point) {
    const std::uint32_t cost = map.map.cost(cell);
    const double part = cost == kCostLethal ? 1.0 : std::ldexp(static_cast<double>(cost), -24);
    weight += std::floor(std::floor(64.0 * robot.planning.clearance_weight + 0.5) * part);
  }
  return std::min(weight, 16383.0);
}

/// Dijkstra over states numbered from 0.
double least_cost(std::size_t states, const std::vector<std::size_t>& starts,
                  const std::function<bool(std::size_t)>& is_goal,
                  const std::function<void(std::size_t, const std::function<void(std::size_t, double)>&)>& edges) {
  std::vector<double> cost(states, std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::size_t start : starts) queue.emplace(cost[start] = 0.0, start);
  while (!queue.empty()) {
    const auto [here, state] = queue.top();
    queue.pop();
    if (here > cost[state]) continue;
    if (is_goal(state)) return here;
    edges(state, [&](std::size_t next, double price) {
      if (here + price < cost[next]) queue.emplace(cost[next] = here + price, next);
    });
  }
  return std::numeric_limits<double>::infinity();
}

std::optional<double> in_metres(double units, double resolution_m) {
  if (!std::isfinite(units)) return std::nullopt;
  return units / (kStraight * 2.0 * 64.0) * resolution_m;
}

/// All the poses of a body on the grid, each tested once.
class PoseTable {
 public:
  PoseTable(const TestMap& map, const Robot& robot) : map_(map), robot_(robot), check_(map, robot) {}

  bool is_free(Cell cell, double heading) const {
    return map_.bounds.contains(cell) && !check_.hits({1.0 * cell.x, 1.0 * cell.y}, angle(heading));
  }
  /// Turning from heading to heading + by, looked at every half degree.
  bool can_turn(Cell cell, int heading, int by) const {
    for (int i = 0; i <= 45 * std::abs(by); ++i) {
      if (!is_free(cell, heading + (by > 0 ? i : -i) / 45.0)) return false;
    }
    return true;
  }
  bool can_step(Cell cell, int heading, const Cell& step) const {
    for (int i = 0; i <= 8; ++i) {
      if (check_.hits({cell.x + step.x * i / 8.0, cell.y + step.y * i / 8.0}, angle(heading))) return false;
    }
    return map_.bounds.contains({cell.x + step.x, cell.y + step.y});
  }
  /// No blocked cell within the circle that holds the body (and half a step more): turning costs nothing.
  bool is_roomy(Cell cell) const {
    const double radius = robot_.circumscribed_radius_m() / map_.map.resolution_m;
    const double radius2 = radius * radius + 0.5;
    const int reach = static_cast<int>(std::ceil(radius)) + 2;
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        const double dx = std::max(std::abs(x) - 0.5, 0.0), dy = std::max(std::abs(y) - 0.5, 0.0);
        if (dx * dx + dy * dy < radius2 - 1e-9 && check_.blocks({cell.x + x, cell.y + y})) return false;
      }
    }
    return map_.bounds.contains(cell);
  }

 private:
  static double angle(double heading) { return heading * std::numbers::pi / 8.0; }
  const TestMap& map_;
  const Robot& robot_;
  PolygonCheck check_;
};

}  // namespace

double weight_of(const TestMap& map, const Robot& robot, planning::BodyMode mode, Cell cell) {
  return weight(map, robot, mode, cell) / 64.0;
}

std::optional<double> dijkstra_cost(const TestMap& map, const Robot& robot, planning::BodyMode mode, Cell start,
                                    Cell goal) {
  const auto width = static_cast<std::size_t>(map.bounds.width());
  const auto index = [&](Cell cell) {
    return static_cast<std::size_t>(cell.y - map.bounds.low.y) * width +
           static_cast<std::size_t>(cell.x - map.bounds.low.x);
  };
  const auto open = [&](Cell cell) { return map.bounds.contains(cell) && !blocks(map, robot, cell); };
  const std::size_t target = index(goal);
  const double units = least_cost(
      static_cast<std::size_t>(map.bounds.height()) * width, {index(start)},
      [&](std::size_t state) { return state == target; },
      [&](std::size_t state, const auto& visit) {
        const Cell cell = {map.bounds.low.x + static_cast<std::int32_t>(state % width),
                           map.bounds.low.y + static_cast<std::int32_t>(state / width)};
        for (const Cell& step : kAround) {
          const Cell next = {cell.x + step.x, cell.y + step.y};
          if (!open(next) || !open({next.x, cell.y}) || !open({cell.x, next.y})) continue;
          const double length = step.x != 0 && step.y != 0 ? kDiagonal : kStraight;
          visit(index(next), length * (weight(map, robot, mode, cell) + weight(map, robot, mode, next)));
        }
      });
  return in_metres(units, map.map.resolution_m);
}

std::optional<double> dijkstra_cost_of_body(const TestMap& map, const Robot& robot, Cell start, Cell goal,
                                            int headings) {
  const PoseTable poses(map, robot);
  const int by = 16 / headings;
  const auto width = static_cast<std::size_t>(map.bounds.width());
  const std::size_t cells = static_cast<std::size_t>(map.bounds.height()) * width;
  const auto cell_of = [&](std::size_t i) {
    return Cell{map.bounds.low.x + static_cast<std::int32_t>(i % width),
                map.bounds.low.y + static_cast<std::int32_t>(i / width)};
  };
  const auto index = [&](Cell cell) {
    return static_cast<std::size_t>(cell.y - map.bounds.low.y) * width +
           static_cast<std::size_t>(cell.x - map.bounds.low.x);
  };
  std::vector<char> free(cells * 16), roomy(cells);
  for (std::size_t i = 0; i < cells; ++i) {
    roomy[i] = poses.is_roomy(cell_of(i));
    for (int h = 0; h < 16; h += by) free[i * 16 + static_cast<std::size_t>(h)] = poses.is_free(cell_of(i), h);
  }
  std::vector<std::size_t> starts;
  for (int h = 0; h < 16; h += by) {
    if (free[index(start) * 16 + static_cast<std::size_t>(h)])
      starts.push_back(index(start) * 16 + static_cast<std::size_t>(h));
  }
  const auto weight_of = [&](Cell cell) { return weight(map, robot, planning::BodyMode::footprint, cell); };
  const double units = least_cost(
      cells * 16, starts, [&](std::size_t state) { return state / 16 == index(goal); },
      [&](std::size_t state, const auto& visit) {
        const Cell cell = cell_of(state / 16);
        const int h = static_cast<int>(state % 16);
        for (const int turn : {by, -by}) {
          const std::size_t next = state / 16 * 16 + static_cast<std::size_t>((h + turn + 16) % 16);
          if (roomy[state / 16]) {
            visit(next, 0.0);
          } else if (free[next] && poses.can_turn(cell, h, turn)) {
            visit(next, by * 2.0 * kStraight * weight_of(cell));
          }
        }
        for (int d = 0; d < 8; ++d) {
          const int off = (h - 2 * d + 32) % 16;  // 0: forwards, 8: backwards, and 22.5 degrees to each side
          const bool forwards = off <= 1 || off == 15, backwards = off >= 7 && off <= 9;
          const Cell step = kAround[static_cast<std::size_t>(d)];
          const Cell there = {cell.x + step.x, cell.y + step.y};
          if (!(forwards || backwards) || !map.bounds.contains(there)) continue;
          const std::size_t next = index(there) * 16 + static_cast<std::size_t>(h);
          if (!free[next]) continue;
          const bool both_roomy = roomy[state / 16] && roomy[next / 16];
          if (both_roomy && (off != 0)) continue;
          if (!poses.can_step(cell, h, step)) continue;
          const double length = (d % 2 != 0 ? kDiagonal : kStraight) * (weight_of(cell) + weight_of(there));
          visit(next, backwards ? 2.0 * length : length);
        }
      });
  return in_metres(units, map.map.resolution_m);
}

}  // namespace scanway::test
