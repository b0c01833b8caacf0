// What the verdict sees at the end of a registration: one CSV line for each of thousands of pairs, right, wrong and
// hopeless. Input of fit_verdict.py.
//   registration_evidence --world yard --world hall --seeds 4 --sweeps 12 > evidence.csv   pairs within worlds, across
//   registration_evidence --data ../shared/data > evidence.csv                             the real sets, and across
#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "common/geometry/pose.h"
#include "tests/bench/registration/evidence/evidence_row.h"
#include "tests/bench/registration/real_pairs.h"
#include "tests/bench/registration/simulated/simulated_scans.h"

namespace {

using namespace scanway;
using namespace scanway::bench;

struct Options {
  std::string data;
  std::vector<std::string> worlds;
  int first_seed = 1, seeds = 1;
  SimulatedPlan plan;
  double min_m = 0.0, max_m = 45.0;
  std::string mode = "tracker";
  int across = 0;
};

bool tracked(const Options& options, Random& random) {
  if (options.mode == "both") return random.below(2) == 0;
  return options.mode == "tracker";
}

/// Scans that share nothing, as their tracker might have them.
OrientationPrior any_prior(Random& random) {
  OrientationPrior prior;
  prior.R_target_source = rotation_about_z(6.28 * random.uniform());
  return prior;
}

void print_world(const Options& options, const SimulatedScans& s, Random& random) {
  for (std::size_t target = 0; target < s.scans.size(); ++target) {
    for (std::size_t source = target + 1; source < s.scans.size(); ++source) {
      const Pose truth = s.T_target_source(source, target);
      const double distance = truth.translation().norm();
      if (distance < options.min_m || distance > options.max_m) continue;
      std::optional<OrientationPrior> prior;
      if (tracked(options, random)) prior = s.prior(source, target);
      print_evidence({s.world, truth, s.overlap(source, target)}, s.scans[source], s.scans[target], prior);
    }
  }
}

using Place = std::vector<PreparedScan>;  // Scans of one place: another place shares nothing with it.

void print_across(const Options& options, const std::vector<std::string>& names, const std::vector<Place>& places,
                  Random& random) {
  for (int k = 0; k < options.across && places.size() > 1; ++k) {
    const std::size_t a = random.below(places.size()), b = random.below(places.size());
    if (a == b || places[a].empty() || places[b].empty()) continue;
    std::optional<OrientationPrior> prior;
    if (tracked(options, random)) prior = any_prior(random);
    const PreparedScan& source = places[a][random.below(places[a].size())];
    const PreparedScan& target = places[b][random.below(places[b].size())];
    print_evidence({"across_" + names[a], std::nullopt}, source, target, prior);
  }
}

void simulated(const Options& options) {
  Random random(static_cast<std::uint64_t>(options.first_seed));
  std::vector<std::string> names;
  std::vector<Place> places;
  for (int seed = options.first_seed; seed < options.first_seed + options.seeds; ++seed) {
    for (const std::string& world : options.worlds) {
      SimulatedScans s = simulate_scans(world, static_cast<std::uint64_t>(seed), options.plan);
      print_world(options, s, random);
      s.scans.resize(std::min<std::size_t>(3, s.scans.size()));
      names.push_back(world);
      places.push_back(std::move(s.scans));
    }
  }
  print_across(options, names, places, random);
}

void real(const Options& options) {
  Random random(1);
  std::vector<Place> places;
  for (const std::string& name : real_set_names()) {
    const RealSet set = load_set(options.data, name);
    Place scans;
    for (const PointCloud& cloud : set.clouds) scans.push_back(PreparedScan::make(cloud, Eigen::Vector3d::Zero(), {}));
    for (std::size_t target = 0; target < scans.size(); ++target) {
      for (std::size_t source = target + 1; source < scans.size(); ++source) {
        const Pose truth = set.T_target_source(source, target);
        const double overlap = std::min(true_overlap(set.clouds[source], set.clouds[target], truth),
                                        true_overlap(set.clouds[target], set.clouds[source], truth.inverse()));
        const KnownPair known{"real_" + name, truth, overlap, set.right_m, set.right_angle};
        const OrientationPrior prior = disturbed_prior(truth, 5.0, 0.5, random);
        if (options.mode != "none") print_evidence(known, scans[source], scans[target], prior);
        if (options.mode != "tracker") print_evidence(known, scans[source], scans[target], std::nullopt);
      }
    }
    places.push_back(std::move(scans));
  }
  print_across(options, real_set_names(), places, random);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"What the verdict sees, as CSV"};
  app.add_option("--data", options.data, "The folder of the real sets");
  app.add_option("--world", options.worlds);
  app.add_option("--first-seed", options.first_seed);
  app.add_option("--seeds", options.seeds);
  app.add_option("--sweeps", options.plan.sweeps, "A world: n of them are n (n - 1) / 2 pairs");
  app.add_option("--span", options.plan.span_m, "Metres of the route on which they stand");
  app.add_option("--thin", options.plan.thin);
  app.add_option("--min", options.min_m, "Metres between the sweeps of a pair, at least");
  app.add_option("--max", options.max_m);
  app.add_option("--mode", options.mode, "tracker, none or both");
  app.add_option("--across", options.across, "Pairs of scans of different places");
  CLI11_PARSE(app, argc, argv);
  print_header();
  if (!options.data.empty()) real(options);
  simulated(options);
}
