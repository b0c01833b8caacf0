// What the verdict sees at right and at wrong poses: a CSV line for each of the best candidates of every pair of the
// real sets (with a tracker and without), and of pairs across sets, which have no right pose.
//   registration_evidence DATA > evidence.csv; fit_verdict.py evidence.csv
#include <cstdio>
#include <string>
#include <vector>

#include "modules/mapper/core/registration/search.h"
#include "tests/bench/registration/real_pairs.h"

namespace {

using namespace scanway;
using namespace scanway::bench;
using namespace scanway::registration;

constexpr std::size_t kCandidates = 4;

struct Prepared {
  RealSet set;
  std::vector<PreparedScan> scans;
};

/// 1 right, 0 wrong, -1 too near the limit to say.
int label_of(const Pose& T, const RealSet& set, const Pose* truth) {
  if (truth == nullptr) return 0;
  const PoseError error = error_of(T, *truth);
  if (error.metres < set.right_m && error.radians < set.right_angle) return 1;
  return error.metres > 3.0 * set.right_m || error.radians > 3.0 * set.right_angle ? 0 : -1;
}

void print_pair(const std::string& name, const RealSet& set, const PreparedScan& source, const PreparedScan& target,
                const std::optional<OrientationPrior>& prior, const Pose* truth) {
  static int pair = 0;
  ++pair;
  std::optional<RotationBounds> bounds;
  if (prior) bounds = bounds_of(*prior);
  const auto candidates = find_candidates(source.data(), target.data(), bounds, SearchWidth::mutual, nullptr);
  for (std::size_t i = 0; i < std::min(kCandidates, candidates.size()); ++i) {
    const IcpResult icp = refine_finely(source.data(), target.data(), candidates[i].T_target_source);
    const Evidence e = evidence_of(source.data(), target.data(), icp);
    const Agreement& a = e.agreement;
    std::printf("%s,%d,%d,%d,%.4f,%.4f,%.5f,%.4f,%.4f,%.5f\n", name.c_str(), pair, prior ? 1 : 0,
                label_of(icp.T_target_source, set, truth), a.overlap, a.overlap_back, a.conflict, a.surface_fit,
                e.rmse_m, e.observability);
  }
  std::fflush(stdout);
}

void print_set(const Prepared& p, Random& random) {
  for (std::size_t target = 0; target < p.scans.size(); ++target) {
    for (std::size_t source = target + 1; source < p.scans.size(); ++source) {
      const Pose truth = p.set.T_target_source(source, target);
      const OrientationPrior prior = disturbed_prior(truth, 5.0, 0.5, random);
      print_pair(p.set.name, p.set, p.scans[source], p.scans[target], prior, &truth);
      print_pair(p.set.name, p.set, p.scans[source], p.scans[target], std::nullopt, &truth);
    }
  }
}

void print_across(const std::vector<Prepared>& all, Random& random) {
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      for (int k = 0; k < 3; ++k) {
        const PreparedScan& source = all[a].scans[random.below(all[a].scans.size())];
        const PreparedScan& target = all[b].scans[random.below(all[b].scans.size())];
        OrientationPrior prior;
        prior.R_target_source = rotation_about_z(6.0 * random.uniform());
        print_pair("across_" + all[a].set.name, all[a].set, source, target, prior, nullptr);
        print_pair("across_" + all[a].set.name, all[a].set, source, target, std::nullopt, nullptr);
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string data = argc > 1 ? argv[1] : "../shared/data";
  std::printf("set,pair,tracker,right,overlap,overlap_back,conflict,surface_fit,rmse_m,observability\n");
  Random random(1);
  std::vector<Prepared> all;
  for (const std::string& name : real_set_names()) {
    Prepared p{load_set(data, name), {}};
    for (const PointCloud& cloud : p.set.clouds) {
      p.scans.push_back(PreparedScan::make(cloud, Eigen::Vector3d::Zero(), {}));
    }
    print_set(p, random);
    all.push_back(std::move(p));
  }
  print_across(all, random);
}
