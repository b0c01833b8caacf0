#include <tbb/global_control.h>

#include <cstdio>

#include "modules/mapper/core/map.h"
#include "tests/bench/mapping/products/cpu_stages.h"
#include "tests/bench/mapping/products/embodiments.h"
#include "tests/bench/mapping/products/voxel_grids.h"
#include "tests/bench/mapping/yard/yard.h"

namespace scanway::bench {
namespace {

/// Full sweeps of the yard into all products at known poses.
void time_products(int sweeps) {
  Robot robot;
  robot.mapping.octomap_resolution_m = 0.05;
  robot.mapping.octomap_max_range_m = 0.0;
  robot.mapping.octomap_discretize = false;
  Map map(robot, 1);
  std::puts("| sweep of 3.4 M points into all products | CPU s | by stage |\n|---|---|---|");
  for (int i = 0; i < sweeps; ++i) {
    const MapPoints points = yard_sweep(i, kFullRound, kFullUp);
    Sweep sweep;
    sweep.cloud.points = points.points;
    sweep.origin = points.origin;
    sweep.sensor_height_m = points.origin.z();
    CpuStages stages;
    map.merge(sweep, Pose::Identity(), &stages);
    std::printf("| %d | %.3f |%s |\n", i + 1, stages.total_s(), stages.text().c_str());
  }
}

}  // namespace
}  // namespace scanway::bench

int main() {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  scanway::bench::compare_voxel_grids();
  scanway::bench::compare_embodiments();
  scanway::bench::time_products(3);
}
