// On the neighbouring pairs of the halls, CPU seconds on one thread, medians over the pairs:
// 1. the stages of a whole registration with the tracker (both scans prepared anew);
// 2. ICP on the chosen surfaces against the same ICP on all points, from the same start 0.3 m and 2 degrees off.
//   registration_bench [DATA]
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <tbb/global_control.h>

#include "modules/mapper/core/registration/icp.h"
#include "modules/mapper/core/registration/normals.h"
#include "modules/mapper/core/registration/prepared_scan.h"
#include "modules/mapper/core/registration/voxel_grid.h"
#include "tests/bench/registration/cpu_stages.h"
#include "tests/bench/registration/real_pairs.h"

namespace {

using namespace scanway;
using namespace scanway::bench;
using namespace scanway::registration;

constexpr std::array<IcpRound, 3> kRounds = {{{0.6f, 0.2f, 10}, {0.5f, 0.1f, 10}, {0.5f, 0.1f, 20, true}}};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

struct Figures {
  std::vector<double> prepare, icp, millimetres, degrees, points;

  void print(const char* name) const {
    std::printf("| %s | %.0f | %.3f | %.4f | %.1f (worst %.1f) | %.3f |\n", name, median(points), median(prepare),
                median(icp), median(millimetres), *std::max_element(millimetres.begin(), millimetres.end()),
                median(degrees));
  }
};

/// Every point of the scan as a piece of surface of its own.
Surfaces all_points(const PreparedScan::Data& scan) {
  const CellGrid& grid = scan.fine;
  const Neighbourhoods neighbourhoods = find_neighbourhoods(grid, 0.35f);
  const Normals normals = estimate_normals(grid.points(), neighbourhoods, 0.35f);
  Surfaces all;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (normals.normal[i].squaredNorm() < 0.5f) continue;
    all.centre.push_back(grid.points()[i]);
    all.normal.push_back(normals.normal[i]);
    all.weight.push_back(1.0f);
    all.size.push_back(0.1f);
  }
  return all;
}

template <class Prepare>
void measure(const PreparedScan::Data& source, const PreparedScan::Data& target, const Pose& start, const Pose& truth,
             const Prepare& prepare, float cell_m, Figures& figures) {
  const double begin = cpu_s();
  const Surfaces from = prepare(source), to = prepare(target);
  const CellGrid grid(to.centre, cell_m);
  const double prepared = cpu_s();
  const IcpResult icp = run_icp(from, {to, grid}, start, kRounds);
  figures.icp.push_back(cpu_s() - prepared);
  figures.prepare.push_back(prepared - begin);
  const PoseError error = error_of(icp.T_target_source, truth);
  figures.millimetres.push_back(1000.0 * error.metres);
  figures.degrees.push_back(error.radians * 57.29577951);
  figures.points.push_back(static_cast<double>(from.count()));
}

void print_stages(const RealSet& set) {
  std::map<std::string, std::vector<double>> seconds;
  Random random(1);
  for (std::size_t target = 0; target + 1 < set.clouds.size(); ++target) {
    const Pose truth = set.T_target_source(target + 1, target);
    const OrientationPrior prior = disturbed_prior(truth, 5.0, 0.5, random);
    CpuStages stages;
    const auto s = PreparedScan::make(set.clouds[target + 1], Eigen::Vector3d::Zero(), {}, &stages);
    const auto t = PreparedScan::make(set.clouds[target], Eigen::Vector3d::Zero(), {}, &stages);
    const RegistrationResult result = register_scans(s, t, prior, {}, &stages);
    double total = 0.0;
    for (const auto& [stage, value] : stages.seconds) {
      seconds[stage].push_back(value);
      total += value;
    }
    seconds["total"].push_back(total);
    const PoseError error = error_of(result.T_target_source, truth);
    seconds["(error, m)"].push_back(error.metres);
  }
  std::printf("| stage | CPU s, median |\n|---|---|\n");
  for (const auto& [stage, values] : seconds) std::printf("| %s | %.4f |\n", stage.c_str(), median(values));
}

}  // namespace

int main(int argc, char** argv) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const RealSet set = load_set(argc > 1 ? argv[1] : "../shared/data", "hall_scans_a");
  print_stages(set);
  Figures chosen, all;
  for (std::size_t i = 0; i + 1 < set.clouds.size(); ++i) {
    const auto s = PreparedScan::make(set.clouds[i + 1], Eigen::Vector3d::Zero(), {});
    const auto t = PreparedScan::make(set.clouds[i], Eigen::Vector3d::Zero(), {});
    const Pose truth = set.T_target_source(i + 1, i);
    Pose start = truth;
    start.linear() = rotation_about_z(2.0 / 57.29577951) * truth.linear();
    start.translation() += Eigen::Vector3d(0.2, 0.2, 0.1);
    measure(
        s.data(), t.data(), start, truth, [](const auto& scan) { return choose_surfaces(scan.fine.points()); }, 1.0f,
        chosen);
    measure(s.data(), t.data(), start, truth, all_points, 0.5f, all);
  }
  std::printf(
      "\n| ICP on | points a scan | preparing, s | ICP, s | error, mm | degrees |\n|---|---|---|---|---|---|\n");
  chosen.print("chosen surfaces");
  all.print("all points");
}
