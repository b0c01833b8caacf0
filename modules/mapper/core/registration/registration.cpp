#include "modules/mapper/core/registration/registration.h"

#include <algorithm>

#include <Eigen/LU>

#include "modules/mapper/core/registration/prepared_scan.h"
#include "modules/mapper/core/registration/search.h"

namespace scanway {
namespace {

using namespace registration;

// The last ICP is run from several candidates while their coarse ranks (log-odds) are near enough to swap.
constexpr std::size_t kFinalists = 3;
constexpr double kSwappable = 4.0;

/// From between the sensors' centres to between the scans' frames.
Pose to_scan_frames(const Pose& T, const PreparedScan::Data& source, const PreparedScan::Data& target) {
  return Eigen::Translation3d(target.origin) * T * Eigen::Translation3d(-source.origin);
}

/// The inverse of the information, scaled by what the residuals say of the noise. Neighbouring pieces of surface share
/// their errors (edges of cells, roughness), so fewer of them are independent than there are.
Matrix6 covariance_of(const IcpResult& icp) {
  constexpr double kDependent = 10.0, kMinSigma = 0.005;
  const double sigma = std::max(icp.rmse_m, kMinSigma);
  Matrix6 information = icp.information;
  information.diagonal().array() += 1e-9 * icp.information.trace() + 1e-12;
  return kDependent * sigma * sigma * information.inverse();
}

RegistrationResult refused(std::string reason) {
  RegistrationResult result;
  result.reason = std::move(reason);
  return result;
}

/// The best candidate, finely registered, with its verdict.
RegistrationResult conclude(const std::vector<Candidate>& candidates, const PreparedScan::Data& source,
                            const PreparedScan::Data& target, StageListener* stages) {
  begin_stage(stages, "icp");
  std::vector<IcpResult> refined;
  std::vector<Candidate> finalists;
  for (std::size_t i = 0; i < std::min(kFinalists, candidates.size()); ++i) {
    if (rank_of(candidates[0].evidence) - rank_of(candidates[i].evidence) > kSwappable) break;
    refined.push_back(refine_finely(source, target, candidates[i].T_target_source));
    finalists.push_back({refined.back().T_target_source, evidence_of(source, target, refined.back())});
  }
  begin_stage(stages, "verdict");
  std::size_t best = 0;
  for (std::size_t i = 1; i < finalists.size(); ++i) {
    if (rank_of(finalists[i].evidence) > rank_of(finalists[best].evidence)) best = i;
  }
  const IcpResult& icp = refined[best];
  Evidence evidence = finalists[best].evidence;
  evidence.margin =
      std::min(margin_to_others(finalists[best], finalists), margin_to_others(finalists[best], candidates));
  RegistrationResult result;
  result.T_target_source = to_scan_frames(icp.T_target_source, source, target);
  result.inlier_rmse_m = icp.rmse_m;
  result.covariance = covariance_of(icp);
  result.overlap = evidence.agreement.overlap;
  decide(evidence, observe(icp), result);
  return result;
}

}  // namespace

RegistrationResult register_scans(const PreparedScan& source, const PreparedScan& target,
                                  const std::optional<OrientationPrior>& prior, const RegistrationConfig&,
                                  StageListener* stages) {
  const PreparedScan::Data &s = source.data(), &t = target.data();
  if (!s.defect.empty()) return refused("The source " + s.defect + ".");
  if (!t.defect.empty()) return refused("The target " + t.defect + ".");
  std::optional<RotationBounds> bounds;
  if (prior) bounds = bounds_of(*prior);
  RegistrationResult result = refused("No pose was found that the scans' features agree on.");
  std::vector<Candidate> candidates;
  for (const SearchWidth width : {SearchWidth::mutual, SearchWidth::wide}) {
    std::vector<Candidate> more = find_candidates(s, t, bounds, width, stages);
    candidates.insert(candidates.end(), more.begin(), more.end());
    candidates = rank_candidates(std::move(candidates));
    if (!candidates.empty()) result = conclude(candidates, s, t, stages);
    if (result.verdict == Verdict::accepted) break;
  }
  begin_stage(stages, "");
  return result;
}

}  // namespace scanway
