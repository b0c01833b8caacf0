#include <octomap/OcTree.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <sstream>
#include <string>
#include <vector>

#include "common/cloud/poses_file.h"
#include "common/cloud/read_cloud.h"
#include "modules/mapper/core/octomap/occupancy_tree.h"
#include "tests/bench/mapping/octomap/threads.h"
#include "tests/bench/mapping/yard/yard.h"

namespace scanway::bench {
namespace {

struct Seconds {
  double cpu = 0.0, wall = 0.0;
};

template <class Work>
Seconds time(const Work& work) {
  const std::clock_t cpu = std::clock();
  const auto wall = std::chrono::steady_clock::now();
  work();
  return {double(std::clock() - cpu) / CLOCKS_PER_SEC,
          std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count()};
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

std::vector<MapPoints> halls(const std::string& folder) {
  const PosesFile poses = PosesFile::read(folder + "/poses_reference.txt");
  std::vector<MapPoints> sweeps;
  for (int i = 0; i < 7; ++i) {
    const std::string name = "scan00" + std::to_string(i);
    const Pose& X = poses.pose_of(name);
    MapPoints sweep;
    sweep.origin = X.translation();
    for (const Eigen::Vector3f& p : read_cloud(folder + "/" + name + ".pcd").points) {
      sweep.points.push_back(transform_in_order(X, p.cast<double>()).cast<float>());
    }
    sweeps.push_back(std::move(sweep));
  }
  return sweeps;
}

void insert_theirs(octomap::OcTree& tree, const MapPoints& sweep, const OccupancyTreeConfig& config) {
  octomap::Pointcloud cloud;
  for (const Eigen::Vector3f& p : sweep.points) cloud.push_back(p.x(), p.y(), p.z());
  const Eigen::Vector3f o = sweep.origin.cast<float>();
  tree.insertPointCloud(cloud, {o.x(), o.y(), o.z()}, config.max_range_m, false, config.discretize);
}

/// One line: seconds a sweep (medians) of both on one thread and of ours on two, and whether the trees are the same.
void compare(const std::string& name, const std::vector<MapPoints>& sweeps, const OccupancyTreeConfig& config) {
  OccupancyTree one(config), two(config);
  octomap::OcTree theirs(config.resolution_m);
  std::vector<double> cpu_theirs, cpu_one, wall_one, wall_two;
  for (const MapPoints& sweep : sweeps) {
    cpu_theirs.push_back(time([&] { insert_theirs(theirs, sweep, config); }).cpu);
    {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
      const Seconds seconds = time([&] { one.insert(sweep); });
      cpu_one.push_back(seconds.cpu);
      wall_one.push_back(seconds.wall);
    }
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
    wall_two.push_back(time([&] { two.insert(sweep); }).wall);
  }
  std::ostringstream bytes;
  theirs.write(bytes);
  const bool same = bytes.str() == one.ot_bytes() && bytes.str() == two.ot_bytes();
  std::printf("| %s | %g | %s | %.3f | %.4f | %.0f | %.2f | %s |\n", name.c_str(), config.resolution_m,
              config.discretize ? "discretised" : "all points", median(cpu_theirs), median(cpu_one),
              median(cpu_theirs) / median(cpu_one), median(wall_one) / median(wall_two), same ? "yes" : "NO");
  std::fflush(stdout);
}

}  // namespace
}  // namespace scanway::bench

int main(int argc, char** argv) {
  using namespace scanway;
  using namespace scanway::bench;
  if (argc != 2) return std::fprintf(stderr, "usage: octomap_bench DATA_FOLDER | yard | threads\n"), 2;
  if (std::string(argv[1]) == "threads") return compare_threads(), 0;
  std::puts(
      "| sweeps | resolution, m | rays | liboctomap, CPU s | ours, CPU s | times less | 2 threads | same bytes |");
  std::puts("|---|---|---|---|---|---|---|---|");
  if (std::string(argv[1]) == "yard") {
    compare("yard, 3.4 M points", {yard_sweep(0, kFullRound, kFullUp)}, {0.05, -1.0, false});
    return 0;
  }
  const std::vector<MapPoints> sweeps = halls(std::string(argv[1]) + "/hall_scans_a");
  for (const double resolution : {0.1, 0.05}) {
    for (const bool discretize : {false, true}) compare("halls", sweeps, {resolution, -1.0, discretize});
  }
  return 0;
}
