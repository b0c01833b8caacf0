#include "tests/bench/registration/paper/paper_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "common/files/input_error.h"
#include "tests/bench/registration/cpu_stages.h"
#include "tests/bench/registration/real_pairs.h"
#include "tests/bench/registration/simulated/simulated_sweep.h"

namespace scanway::bench {
namespace {

struct Run {
  double rough_s = 0.0, fine_s = 0.0;
  PoseError error;
  RegistrationResult result;
  std::size_t points = 0;
};

/// The runs of a distance, by world; under an empty name those of all.
using Runs = std::map<std::string, std::vector<Run>>;

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double sum = 0.0;
  for (const double v : values) sum += (v - mean) * (v - mean);
  return values.size() > 1 ? std::sqrt(sum / static_cast<double>(values.size() - 1)) : 0.0;
}

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

Run run_pair(const std::string& world, int thin, double distance_m, std::uint64_t seed) {
  const SimulatedPair pair = simulate_pair(world, seed, distance_m, thin);
  const RegistrationConfig limits = simulated_limits(seed);
  CpuStages stages;
  const double begin = cpu_s();
  const PreparedScan source = PreparedScan::make(pair.source.cloud, pair.source.origin, limits, &stages);
  const PreparedScan target = PreparedScan::make(pair.target.cloud, pair.target.origin, limits, &stages);
  Run run;
  run.result = register_scans(source, target, pair.prior(), limits, &stages);
  run.fine_s = stages.of("surfaces") + stages.of("icp") + stages.of("verdict");
  run.rough_s = cpu_s() - begin - run.fine_s;
  run.error = error_of(run.result.T_target_source, pair.T_target_source());
  run.points = pair.source.cloud.size() + pair.target.cloud.size();
  return run;
}

template <class Value>
std::vector<double> all_of(const std::vector<Run>& runs, const Value& value) {
  std::vector<double> values;
  for (const Run& run : runs) values.push_back(value(run));
  return values;
}

void print_case(const std::string& world, double distance_m, const std::vector<Run>& runs) {
  const auto rough = all_of(runs, [](const Run& r) { return r.rough_s; });
  const auto fine = all_of(runs, [](const Run& r) { return r.fine_s; });
  std::vector<double> millimetres;
  for (const Run& run : runs) {
    if (run.result.verdict == Verdict::accepted) millimetres.push_back(1000.0 * run.error.metres);
  }
  const auto points = all_of(runs, [](const Run& r) { return 0.5e-6 * static_cast<double>(r.points); });
  std::printf("| %s | %.0f m | %.2f | %.2f ± %.2f | %.2f ± %.2f | %.1f (worst %.1f) | %zu of %zu |\n",
              world.empty() ? "**all**" : world.c_str(), distance_m, mean_of(points), mean_of(rough),
              deviation_of(rough), mean_of(fine), deviation_of(fine), median_of(millimetres),
              millimetres.empty() ? 0.0 : *std::max_element(millimetres.begin(), millimetres.end()), millimetres.size(),
              runs.size());
}

void print_run(const std::string& world, int seed, double distance_m, const Run& run) {
  std::printf("%s %d, %.0f m: %s, p %.3f, overlap %.2f, %.1f mm, %.3f degrees. %s\n", world.c_str(), seed, distance_m,
              run.result.verdict == Verdict::accepted ? "accepted" : "refused", run.result.probability,
              run.result.overlap, 1000.0 * run.error.metres, run.error.radians * 57.29577951,
              run.result.reason.c_str());
  std::fflush(stdout);
}

Runs run_all(const TableOptions& options, double distance_m) {
  Runs runs;
  for (const std::string& world : options.worlds) {
    for (int seed = 1; seed <= options.runs; ++seed) {
      try {
        const Run run = run_pair(world, options.thin, distance_m, static_cast<std::uint64_t>(seed));
        print_run(world, seed, distance_m, run);
        runs[world].push_back(run);
        if (options.worlds.size() > 1) runs[""].push_back(run);
      } catch (const InputError& none) {
        std::printf("%s %d, %.0f m: %s\n", world.c_str(), seed, distance_m, none.what());
      }
    }
  }
  return runs;
}

}  // namespace

void print_paper_table(const TableOptions& options) {
  const std::vector<double> distances = {10.0, 35.0};
  std::vector<Runs> cases;
  for (const double distance_m : distances) cases.push_back(run_all(options, distance_m));
  std::printf(
      "\n| world | apart | million points a sweep | FPFH, CPU s | ICP, CPU s | of those accepted: error, mm, median | "
      "accepted |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (const auto& [world, runs] : cases[i]) print_case(world, distances[i], runs);
  }
}

}  // namespace scanway::bench
