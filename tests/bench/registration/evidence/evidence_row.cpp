#include "tests/bench/registration/evidence/evidence_row.h"

#include <cstdio>
#include <ctime>

namespace scanway::bench {
namespace {

using namespace registration;

/// 1 right, 0 wrong.
int label_of(const KnownPair& known, const PoseError& error) {
  return known.truth && error.metres < known.right_m && error.radians < known.right_angle ? 1 : 0;
}

/// How far off the ICP was before the last step.
double icp_error_m(const KnownPair& known, const Conclusion& conclusion, const PreparedScan& source,
                   const PreparedScan& target) {
  if (!known.truth) return 99.0;
  const Pose T = Eigen::Translation3d(target.data().origin) * conclusion.icp.T_target_source *
                 Eigen::Translation3d(-source.data().origin);
  return error_of(T, *known.truth).metres;
}

}  // namespace

void print_header() {
  std::printf(
      "set,tracker,right,true_overlap,distance,error_m,error_deg,accepted,p,open,overlap,overlap_back,conflict,"
      "surface_fit,held_fit,rmse_m,icp_rmse_m,moved_m,margin,observability,rank,matches,sigma_m,sigma_deg,icp_error_m,"
      "facing,cpu_s\n");
}

void print_evidence(const KnownPair& known, const PreparedScan& source, const PreparedScan& target,
                    const std::optional<OrientationPrior>& prior) {
  constexpr double kDegrees = 57.29577951308232;
  const std::clock_t begin = std::clock();
  if (!source.data().defect.empty() || !target.data().defect.empty()) return;
  const auto [result, conclusion] = attempt_registration(source.data(), target.data(), prior, nullptr);
  const double cpu_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  if (!conclusion) return;
  const Evidence& e = conclusion->evidence;
  const Agreement& a = e.agreement;
  const PoseError error = known.truth ? error_of(result.T_target_source, *known.truth) : PoseError{99.0, 3.0};
  std::printf("%s,%d,%d,%.3f,%.2f,%.5f,%.4f,%d,%.5f,%zu,", known.set.c_str(), prior ? 1 : 0, label_of(known, error),
              known.overlap, known.truth ? known.truth->translation().norm() : 999.0, error.metres,
              error.radians * kDegrees, result.verdict == Verdict::accepted ? 1 : 0, result.probability,
              result.open_directions.size());
  std::printf("%.4f,%.4f,%.5f,%.4f,%.4f,%.5f,%.5f,%.5f,%.3f,%.5f,%.3f,%zu,%.5f,%.5f,%.5f,%.0f,%.3f\n", a.overlap,
              a.overlap_back, a.conflict, a.surface_fit, e.held_fit, result.inlier_rmse_m, e.rmse_m, e.moved_m,
              e.margin, e.observability, rank_of(e), conclusion->last.matches, e.sigma_m, e.sigma_rad * kDegrees,
              icp_error_m(known, *conclusion, source, target), conclusion->facing[0], cpu_s);
  std::fflush(stdout);
}

}  // namespace scanway::bench
