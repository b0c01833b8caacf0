// First plans of the planner beside those of others, corner to corner, one thread, CPU time.

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "modules/planner/core/planner.h"
#include "tests/bench/planning/cpu_time.h"
#include "tests/bench/planning/peers/boost_a_star.h"
#include "tests/bench/planning/scenes.h"

int main(int argc, char** argv) {
  using namespace scanway;
  using namespace scanway::bench;
  const int side = argc > 1 ? std::atoi(argv[1]) : 2000;
  std::printf("%d x %d cells, corner to corner, CPU ms\n", side, side);
  std::printf(
      "| map | Boost.Graph's A* (without making the graph) | textbook A* | first plan | times faster than Boost |\n");
  std::printf("|---|---|---|---|---|\n");
  for (const auto& make : {rubble, rooms, weighted}) {
    const Scene scene = make(side);
    const PlainMap map = plain(scene);
    const BoostAStar boost(map);
    PlainAnswer theirs, textbook;
    planning::PlanResult ours;
    const double boost_ms = cpu_ms([&] { theirs = boost.search(); });
    const double textbook_ms = cpu_ms([&] { textbook = textbook_a_star(map); });
    planning::Planner planner(Robot(), scene.mode);
    planner.set_map(scene.map, CellRectangle{{0, 0}, {side, side}});
    const double ours_ms = cpu_ms([&] { ours = planner.plan({0.5, 0.5}, {side - 0.5, side - 0.5}); });
    std::printf("| %s | %.0f | %.0f | %.0f | %.1f |\n", scene.name, boost_ms, textbook_ms, ours_ms, boost_ms / ours_ms);
    // Boost's weights are floats, and their sum is not exact.
    if (std::fabs(ours.cost - theirs.cost) > 0.01 + 1e-5 * ours.cost) {
      std::printf("the costs differ: %.3f, Boost's %.3f, the textbook's %.3f\n", ours.cost, theirs.cost, textbook.cost);
    }
    std::fflush(stdout);
  }
}
