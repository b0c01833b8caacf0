#include <tbb/global_control.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "modules/mapper/core/map.h"
#include "modules/mapper/node/bytes_on_disk.h"
#include "modules/mapper/node/sweeps_on_disk.h"
#include "tests/bench/mapping/products/cpu_stages.h"
#include "tests/bench/mapping/yard/yard.h"

namespace scanway::bench {
namespace {

struct Options {
  int sweeps = 50;
  int thin = 1;                ///< Only every thin-th line, and of it every thin-th beam.
  double resolution_m = 0.05;  ///< Of the OctoMap.
  double max_range_m = 0.0;    ///< Of its beams; 0: none.
};

/// VmRSS or VmHWM of this process, MB.
long memory_mb(const std::string& what) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(what + ":", 0) == 0) return std::atol(line.c_str() + what.size() + 1) / 1024;
  }
  return 0;
}

Sweep sweep_at_stop(int number, int thin) {
  MapPoints points = site_sweep(number, kFullRound / thin, kFullUp / thin);
  Sweep sweep;
  sweep.name = std::to_string(number);
  sweep.cloud.points = std::move(points.points);
  sweep.origin = points.origin;
  sweep.sensor_height_m = points.origin.z();
  return sweep;
}

Robot robot_with(const Options& options) {
  Robot robot;
  robot.mapping.octomap_resolution_m = options.resolution_m;
  robot.mapping.octomap_max_range_m = options.max_range_m;
  robot.mapping.octomap_discretize = false;
  return robot;
}

void print(const std::string& what, const CpuStages& stages) {
  std::printf("| %s | %.3f |%s | %ld | %ld |\n", what.c_str(), stages.total_s(), stages.text().c_str(),
              memory_mb("VmRSS"), memory_mb("VmHWM"));
  std::fflush(stdout);
}

Pose shifted(double x_m) { return Pose(Eigen::Translation3d(x_m, 0.0, 0.0)); }

void revise(Map& map, int sweeps) {
  const auto some = static_cast<SweepNumber>(sweeps / 2);
  CpuStages withdrawal, return_of_it, closure;
  map.withdraw(some, &withdrawal);
  print("one withdrawn", withdrawal);
  map.move({{some, shifted(0.02)}}, &return_of_it);
  print("and put back 2 cm further", return_of_it);
  std::vector<SweepMove> moves;
  for (int i = sweeps - sweeps / 5; i < sweeps; ++i) moves.push_back({static_cast<SweepNumber>(i), shifted(0.03)});
  map.move(moves, &closure);
  print("the last " + std::to_string(moves.size()) + " moved by 3 cm", closure);
}

void measure(const Options& options) {
  Map map(robot_with(options), 1, {std::make_unique<SweepsOnDisk>(), std::make_shared<BytesOnDisk>()});
  std::puts("| sweep | CPU s | by stage | resident, MB | at most, MB |\n|---|---|---|---|---|");
  for (int i = 0; i < options.sweeps; ++i) {
    const Sweep sweep = sweep_at_stop(i, options.thin);
    CpuStages stages;
    map.merge(sweep, Pose::Identity(), &stages);
    if (i < 6 || i % 5 == 4) print(std::to_string(i + 1), stages);
  }
  revise(map, options.sweeps);
}

}  // namespace
}  // namespace scanway::bench

int main(int argc, char** argv) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  scanway::bench::Options options;
  if (argc > 5) return std::fprintf(stderr, "usage: site_bench [SWEEPS [THIN [RESOLUTION_M [MAX_RANGE_M]]]]\n"), 2;
  if (argc > 1) options.sweeps = std::atoi(argv[1]);
  if (argc > 2) options.thin = std::atoi(argv[2]);
  if (argc > 3) options.resolution_m = std::atof(argv[3]);
  if (argc > 4) options.max_range_m = std::atof(argv[4]);
  scanway::bench::measure(options);
}
