// First plans and replans of the planner against a textbook A*, corner to corner, one thread, CPU time.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "common/random/random.h"
#include "modules/planner/core/planner.h"
#include "tests/bench/planning/textbook.h"

namespace scanway::bench {
namespace {

using planning::BodyMode;
using planning::Planner;
using planning::PlanResult;

struct Scene {
  const char* name;
  BodyMode mode;
  CostMap map;
  std::int32_t side;
};

double clearance_weight() { return Robot().planning.clearance_weight; }

CostMap make_map(std::int32_t side) {
  CostMap map;
  map.resolution_m = 1.0;
  for (std::int32_t y = 0; y < side; ++y) {
    for (std::int32_t x = 0; x < side; ++x) map.set_state({x, y}, CellState::free);
  }
  return map;
}

/// Single cells, a fifth of all.
Scene rubble(std::int32_t side) {
  Scene scene{"rubble", BodyMode::point, make_map(side), side};
  Random random(1);
  for (std::int32_t y = 0; y < side; ++y) {
    for (std::int32_t x = 0; x < side; ++x) {
      const bool corner = std::max(x, y) < 5 || std::min(x, y) > side - 6;
      if (random.below(5) == 0 && !corner) scene.map.set_state({x, y}, CellState::occupied);
    }
  }
  return scene;
}

/// Rooms of 80 cells; three of four walls have a door of 4 cells.
Scene rooms(std::int32_t side) {
  constexpr std::int32_t kRoom = 80;
  Scene scene{"rooms", BodyMode::point, make_map(side), side};
  Random random(2);
  const auto wall = [&](std::int32_t line, std::int32_t from, bool upright) {
    const bool door = random.below(4) != 0;
    const auto at = static_cast<std::int32_t>(2 + random.below(kRoom - 8));
    for (std::int32_t i = 0; i < kRoom; ++i) {
      if (door && i >= at && i < at + 4) continue;
      scene.map.set_state(upright ? Cell{line, from + i} : Cell{from + i, line}, CellState::occupied);
    }
  };
  for (std::int32_t line = kRoom - 1; line < side - 1; line += kRoom) {
    for (std::int32_t from = 0; from < side; from += kRoom) {
      wall(line, from, true);
      wall(line, from, false);
    }
  }
  return scene;
}

/// No obstacle; costs change smoothly between 0 and kCostOne.
Scene weighted(std::int32_t side) {
  Scene scene{"weighted", BodyMode::paper, make_map(side), side};
  for (std::int32_t y = 0; y < side; ++y) {
    for (std::int32_t x = 0; x < side; ++x) {
      const double hills = 0.5 + 0.25 * (std::sin(x / 37.0) * std::cos(y / 53.0) + std::sin((x + 2.0 * y) / 91.0));
      scene.map.set_cost({x, y}, static_cast<std::uint32_t>(hills * kCostOne));
    }
  }
  return scene;
}

/// The same prices as docs/planning.md has them.
PlainMap plain(const Scene& scene) {
  PlainMap map{scene.side, {}};
  for (std::int32_t y = 0; y < scene.side; ++y) {
    for (std::int32_t x = 0; x < scene.side; ++x) {
      const double share = scene.mode == BodyMode::point ? 0.0 : std::ldexp(scene.map.cost({x, y}), -24);
      const double price = (64.0 + std::floor(std::floor(64.0 * clearance_weight() + 0.5) * share)) / 64.0;
      map.price.push_back(scene.map.state({x, y}) == CellState::free ? static_cast<float>(price) : 0.0f);
    }
  }
  return map;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

template <class Work>
double cpu_ms(Work&& work) {
  const std::clock_t begin = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// 200 x 200 cells begin 20 cells from the robot: a twentieth of them becomes an obstacle.
std::vector<Cell> disturb(Scene& scene, Random& random) {
  for (std::int32_t y = 20; y < 220; ++y) {
    for (std::int32_t x = 20; x < 220; ++x) {
      if (random.below(20) == 0) scene.map.set_state({x, y}, CellState::occupied);
    }
  }
  return {{0, 0}, {1, 0}, {0, 1}, {1, 1}};  // Tiles of 128 cells.
}

struct Row {
  std::vector<double> textbook_ms, first_ms, replan_ms;
  PlainAnswer textbook;
  PlanResult first, replan;
  double replan_textbook_cost = 0.0;
};

Row measure(const Scene& original, int runs) {
  Row row;
  for (int run = 0; run < runs; ++run) {
    Scene scene = original;
    const PlainMap map = plain(scene);
    row.textbook_ms.push_back(cpu_ms([&] { row.textbook = textbook_a_star(map); }));
    Planner planner(Robot(), scene.mode);
    planner.set_map(scene.map, CellRectangle{{0, 0}, {scene.side, scene.side}});
    const auto plan = [&] { return planner.plan({0.5, 0.5}, {scene.side - 0.5, scene.side - 0.5}); };
    row.first_ms.push_back(cpu_ms([&] { row.first = plan(); }));
    Random random(3);
    const std::vector<Cell> tiles = disturb(scene, random);
    row.replan_ms.push_back(cpu_ms([&] {
      planner.update(scene.map, tiles);
      row.replan = plan();
    }));
    if (run == 0) row.replan_textbook_cost = textbook_a_star(plain(scene)).cost;
  }
  return row;
}

void print(const char* name, const Row& row) {
  const double textbook = median(row.textbook_ms), first = median(row.first_ms), replan = median(row.replan_ms);
  std::printf("| %s | %.0f | %.0f | %.1f | %.1f | %.0f | %llu | %llu | %llu |\n", name, textbook, first,
              textbook / first, replan, first / replan, static_cast<unsigned long long>(row.textbook.expansions),
              static_cast<unsigned long long>(row.first.effort.expansions),
              static_cast<unsigned long long>(row.replan.effort.expansions + row.replan.effort.dropped));
  if (std::fabs(row.first.cost - row.textbook.cost) > 0.01 ||
      std::fabs(row.replan.cost - row.replan_textbook_cost) > 0.01) {
    std::printf("the costs differ: %.3f and %.3f, replanned %.3f and %.3f\n", row.first.cost, row.textbook.cost,
                row.replan.cost, row.replan_textbook_cost);
  }
  std::fflush(stdout);
}

}  // namespace
}  // namespace scanway::bench

int main(int argc, char** argv) {
  using namespace scanway::bench;
  const int runs = argc > 1 ? std::atoi(argv[1]) : 5;
  const int side = argc > 2 ? std::atoi(argv[2]) : 4000;
  std::printf("%d x %d cells, corner to corner, CPU ms, medians of %d\n", side, side, runs);
  std::printf(
      "| map | textbook A* | first plan | times faster | replan | times faster than first | expanded by A* | by "
      "the first plan | by the replan, with dropped |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& make : {rubble, rooms, weighted}) {
    const Scene scene = make(side);
    print(scene.name, measure(scene, runs));
  }
}
