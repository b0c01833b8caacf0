#include "modules/mapper/core/registration/registration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "modules/mapper/core/registration/agreement.h"
#include "modules/mapper/core/registration/consensus.h"
#include "modules/mapper/core/registration/icp.h"
#include "modules/mapper/core/registration/matching.h"
#include "modules/mapper/core/registration/prepared_scan.h"
#include "modules/mapper/core/registration/verdict.h"

namespace scanway {
namespace {

using namespace registration;

constexpr std::array<IcpRound, 2> kCoarse = {{{1.2f, 0.4f, 6}, {0.6f, 0.2f, 8}}};
constexpr std::array<IcpRound, 2> kFine = {{{0.5f, 0.1f, 10}, {0.4f, 0.03f, 15}}};
constexpr std::size_t kCoarseSamples = 1500, kFineSamples = 8000;
constexpr double kDistinctMetres = 0.5, kDistinctRadians = 0.09;

struct Candidate {
  Pose T_target_source;
  Agreement agreement;
};

RotationBounds bounds_of(const OrientationPrior& prior) {
  // Three deviations, and never less than what a tracker may be off by near iron or after a knock.
  return {prior.R_target_source, std::max(3.0 * prior.heading_sigma, 0.2), std::max(4.0 * prior.tilt_sigma, 0.11)};
}

bool distinct(const Pose& a, const Pose& b) {
  const Pose d = a.inverse() * b;
  return d.translation().norm() > kDistinctMetres || rotation_angle(d.linear()) > kDistinctRadians;
}

/// Hypotheses refined by a short ICP and ranked by how well the scans agree there; of like ones, the best.
std::vector<Candidate> refine(const std::vector<Hypothesis>& hypotheses, const PreparedScan::Data& source,
                              const PreparedScan::Data& target, const std::optional<RotationBounds>& bounds) {
  const IcpTarget icp_target{target.surfaces, target.surface_grid};
  std::vector<Candidate> all;
  for (const Hypothesis& h : hypotheses) {
    const IcpResult icp = run_icp(source.few_surfaces, icp_target, h.T_target_source, kCoarse);
    if (bounds && !within(*bounds, icp.T_target_source.linear())) continue;
    all.push_back({icp.T_target_source, assess(source, target, icp.T_target_source, kCoarseSamples)});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.agreement.score > b.agreement.score; });
  std::vector<Candidate> kept;
  for (const Candidate& c : all) {
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Candidate& k) {
      return !distinct(k.T_target_source, c.T_target_source);
    });
    if (!known) kept.push_back(c);
  }
  return kept;
}

std::vector<Hypothesis> search(const PreparedScan::Data& source, const PreparedScan::Data& target,
                               const std::optional<RotationBounds>& bounds, StageListener* stages) {
  begin_stage(stages, "matching");
  std::optional<Eigen::Matrix3f> R;
  if (bounds) R = bounds->R_target_source.cast<float>();
  const std::vector<Match> matches = match_keypoints(source.keypoints, target.keypoints, R);
  begin_stage(stages, "hypotheses");
  return find_hypotheses(source.keypoints, target.keypoints, matches, bounds, ConsensusOptions{});
}

/// From between the sensors' centres to between the scans' frames.
Pose to_scan_frames(const Pose& T, const PreparedScan::Data& source, const PreparedScan::Data& target) {
  return Eigen::Translation3d(target.origin) * T * Eigen::Translation3d(-source.origin);
}

/// The inverse of the information, scaled by what the residuals say of the noise. Neighbouring pieces of surface share
/// their errors (edges of cells, roughness), so fewer of them are independent than there are.
Eigen::Matrix<double, 6, 6> covariance_of(const IcpResult& icp) {
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

RegistrationResult conclude(const std::vector<Candidate>& candidates, const PreparedScan::Data& source,
                            const PreparedScan::Data& target, StageListener* stages) {
  begin_stage(stages, "icp");
  const IcpResult icp = run_icp(source.surfaces, {target.surfaces, target.surface_grid},
                                candidates.front().T_target_source, kFine);
  begin_stage(stages, "verdict");
  RegistrationResult result;
  result.T_target_source = to_scan_frames(icp.T_target_source, source, target);
  result.inlier_rmse_m = icp.rmse_m;
  result.covariance = covariance_of(icp);
  const Observability observability = observe(icp);
  Evidence evidence;
  evidence.agreement = assess(source, target, icp.T_target_source, kFineSamples);
  evidence.rmse_m = icp.rmse_m;
  evidence.observability = observability.weakest;
  evidence.margin = candidates.size() > 1 ? candidates[0].agreement.score - candidates[1].agreement.score : 1.0;
  result.overlap = evidence.agreement.overlap;
  decide(evidence, observability, result);
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
  const std::vector<Hypothesis> hypotheses = search(s, t, bounds, stages);
  begin_stage(stages, "checks");
  const std::vector<Candidate> candidates = refine(hypotheses, s, t, bounds);
  if (candidates.empty()) return refused("No pose was found that the scans' features agree on.");
  RegistrationResult result = conclude(candidates, s, t, stages);
  begin_stage(stages, "");
  return result;
}

}  // namespace scanway
