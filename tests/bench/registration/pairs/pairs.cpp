// Registers every pair of the real sets and prints what came out beside the reference, one line a pair.
//   registration_pairs --data ../shared/data [--set NAME]... [--mode tracker|turned|none] [--seeds N] [--neighbours]
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include <tbb/global_control.h>
#include <CLI/CLI.hpp>

#include "common/math/repeatable.h"
#include "common/progress/stage_timer.h"
#include "tests/bench/registration/real_pairs.h"

namespace {

using namespace scanway;
using namespace scanway::bench;

struct Options {
  std::string data = "../shared/data";
  std::vector<std::string> sets;
  std::string mode = "tracker";
  int seeds = 1;
  int threads = 1;
  bool neighbours = false;
  bool stages = false;
};

struct Tally {
  int right = 0, refused = 0, wrong = 0, lost = 0;
};

std::optional<OrientationPrior> prior_of(const Options& options, const Pose& truth, Random& random) {
  if (options.mode == "none") return std::nullopt;
  if (options.mode == "turned") return turned_prior(truth, 5.0, random);
  return disturbed_prior(truth, 5.0, 0.5, random);
}

void run_pair(const Options& options, const RealSet& set, const std::vector<PreparedScan>& scans, std::size_t source,
              std::size_t target, int seed, Tally& tally) {
  const Pose truth = set.T_target_source(source, target);
  Random random(static_cast<std::uint64_t>(seed) * 1000 + source * 30 + target);
  StageTimer timer;
  const std::clock_t begin = std::clock();
  const RegistrationResult result =
      register_scans(scans[source], scans[target], prior_of(options, truth, random), {}, &timer);
  const PoseError error = error_of(result.T_target_source, truth);
  const bool right = error.metres < set.right_m && error.radians < set.right_angle;
  const bool accepted = result.verdict == Verdict::accepted;
  const double overlap = true_overlap(set.clouds[source], set.clouds[target], truth);
  tally.right += accepted && right;
  tally.wrong += accepted && !right;
  tally.refused += !accepted;
  tally.lost += !accepted && overlap >= 0.3;
  timer.finish();
  std::fflush(stdout);
  std::printf(
      "%-12.12s %s>%s seed %d true overlap %.2f: %s %s %.4f m %.3f deg p=%.3f overlap %.2f rmse %.3f cpu %.3f s %s\n",
      set.name.c_str(), set.scans[source].c_str(), set.scans[target].c_str(), seed, overlap,
      accepted ? "accepted" : "refused ", right ? "right" : "WRONG", error.metres,
      error.radians * 180.0 / repeatable::kPi, result.probability, result.overlap, result.inlier_rmse_m,
      static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, result.reason.c_str());
  if (options.stages) {
    for (const auto& [name, seconds] : timer.finish()) std::printf("    %s %.3f", name.c_str(), seconds);
    std::printf("\n");
  }
}

void run_set(const Options& options, const std::string& name) {
  const RealSet set = load_set(options.data, name);
  std::vector<PreparedScan> scans;
  StageTimer timer;
  for (const PointCloud& cloud : set.clouds) {
    scans.push_back(PreparedScan::make(cloud, Eigen::Vector3d::Zero(), {}, &timer));
  }
  Tally tally;
  for (std::size_t target = 0; target < scans.size(); ++target) {
    for (std::size_t source = target + 1; source < scans.size(); ++source) {
      if (options.neighbours && source != target + 1) continue;
      for (int seed = 1; seed <= options.seeds; ++seed) run_pair(options, set, scans, source, target, seed, tally);
    }
  }
  std::printf("%s: right %d, wrong %d, refused %d (%d of overlap 0.3 or more); preparing a scan:", name.c_str(),
              tally.right, tally.wrong, tally.refused, tally.lost);
  for (const auto& [stage, seconds] : timer.finish()) {
    std::printf(" %s %.3f", stage.c_str(), seconds / static_cast<double>(scans.size()));
  }
  std::printf(" s\n");
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Registers every pair of the real sets"};
  app.add_option("--data", options.data);
  app.add_option("--set", options.sets);
  app.add_option("--mode", options.mode);
  app.add_option("--seeds", options.seeds);
  app.add_option("--threads", options.threads);
  app.add_flag("--neighbours", options.neighbours);
  app.add_flag("--stages", options.stages);
  CLI11_PARSE(app, argc, argv);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(options.threads));
  for (const std::string& name : options.sets.empty() ? real_set_names() : options.sets) run_set(options, name);
}
