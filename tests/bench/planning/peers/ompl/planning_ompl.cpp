// Plans for a point beside those of OMPL's planners, which know no grid: corner to corner, one run each, CPU time.
//
//   planning_ompl [SIDE] [SECONDS]     what the samplers may take, wall time

#include <cstdio>
#include <cstdlib>

#include <ompl/util/RandomNumbers.h>

#include "modules/planner/core/planner.h"
#include "tests/bench/planning/cpu_time.h"
#include "tests/bench/planning/peers/ompl/sampling.h"

namespace scanway::bench {
namespace {

void compare(const Scene& scene, double most_seconds) {
  planning::PlanResult ours;
  const double ours_ms = cpu_ms([&] {
    planning::Planner planner(Robot(), planning::BodyMode::point, planning::PathForm::smooth);
    planner.set_map(scene.map, CellRectangle{{0, 0}, {scene.side, scene.side}});
    ours = planner.plan({0.5, 0.5}, {scene.side - 0.5, scene.side - 0.5});
  });
  for (const Sampler sampler : {Sampler::rrt_connect, Sampler::bit_star, Sampler::prm_star}) {
    const auto theirs = sample(scene, sampler, most_seconds);
    std::printf("| %s, %d | %.0f ms, %.1f m | %s | ", scene.name, scene.side, ours_ms, ours.length_m, name_of(sampler));
    if (theirs) {
      std::printf("%.0f ms, %.1f m | %.1f | %.3f |\n", theirs->ms, theirs->length, theirs->ms / ours_ms,
                  theirs->length / ours.length_m);
    } else {
      std::printf("none in %g s | > %.0f | - |\n", most_seconds, 1e3 * most_seconds / ours_ms);
    }
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace scanway::bench

int main(int argc, char** argv) {
  using namespace scanway::bench;
  const int side = argc > 1 ? std::atoi(argv[1]) : 500;
  const double seconds = argc > 2 ? std::atof(argv[2]) : 10.0;
  ompl::RNG::setSeed(1);
  std::printf("corner to corner; ours with the map's preparation, straightened\n");
  std::printf("| map, cells a side | ours | OMPL's | | times slower | times longer |\n|---|---|---|---|---|---|\n");
  compare(rooms(side), seconds);
  compare(rubble(side), seconds);
}
