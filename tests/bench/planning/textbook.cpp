#include "tests/bench/planning/textbook.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace scanway::bench {

PlainAnswer textbook_a_star(const PlainMap& map) {
  const std::int32_t n = map.side;
  const double root = std::sqrt(2.0);
  const std::int32_t goal = n * n - 1;
  const auto octile = [&](std::int32_t i) {
    const double x = n - 1 - i % n, y = n - 1 - i / n;
    return std::max(x, y) + (root - 1.0) * std::min(x, y);
  };
  const auto is_free = [&](std::int32_t x, std::int32_t y) {
    return x >= 0 && y >= 0 && x < n && y < n && map.price[static_cast<std::size_t>(y * n + x)] > 0.0f;
  };
  std::vector<double> cost(map.price.size(), std::numeric_limits<double>::infinity());
  std::vector<char> closed(map.price.size());
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost[0] = 0.0;
  open.emplace(octile(0), 0);
  PlainAnswer answer;
  while (!open.empty()) {
    const std::int32_t here = open.top().second;
    open.pop();
    const auto i = static_cast<std::size_t>(here);
    if (closed[i]) continue;
    closed[i] = 1;
    if (here == goal) break;
    ++answer.expansions;
    const std::int32_t x = here % n, y = here / n;
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
      for (std::int32_t dx = -1; dx <= 1; ++dx) {
        if ((dx == 0 && dy == 0) || !is_free(x + dx, y + dy)) continue;
        if (dx != 0 && dy != 0 && !(is_free(x + dx, y) && is_free(x, y + dy))) continue;
        const auto j = static_cast<std::size_t>((y + dy) * n + x + dx);
        const double step = (dx != 0 && dy != 0 ? root : 1.0) * 0.5 * (map.price[i] + map.price[j]);
        if (cost[i] + step >= cost[j]) continue;
        cost[j] = cost[i] + step;
        open.emplace(cost[j] + octile(static_cast<std::int32_t>(j)), static_cast<std::int32_t>(j));
      }
    }
  }
  answer.cost = cost[static_cast<std::size_t>(goal)];
  return answer;
}

}  // namespace scanway::bench
