#include "modules/mapper/core/registration/conclusion.h"

#include <algorithm>

#include "common/parallel/blocks.h"

namespace scanway::registration {
namespace {

// The last ICP is run from several candidates while their coarse ranks (log-odds) are near enough to swap.
constexpr std::size_t kFinalists = 3;
constexpr double kSwappable = 4.0;
constexpr double kSmallStep = 0.02;  // metres: below, the spacing of the points decides how close clouds lie

/// From between the sensors' centres to between the scans' frames.
Pose to_scan_frames(const Pose& T, const PreparedScan::Data& source, const PreparedScan::Data& target) {
  return Eigen::Translation3d(target.origin) * T * Eigen::Translation3d(-source.origin);
}

struct Finalist {
  IcpResult icp;
  Candidate candidate;
};

std::vector<Finalist> refine(const std::vector<Candidate>& candidates, const PreparedScan::Data& source,
                             const PreparedScan::Data& target) {
  std::size_t count = 0;
  while (count < std::min(kFinalists, candidates.size()) &&
         rank_of(candidates[0].evidence) - rank_of(candidates[count].evidence) <= kSwappable) {
    ++count;
  }
  std::vector<Finalist> finalists(count);
  for_blocks(count, 1, [&](std::size_t i, std::size_t, std::size_t) {
    const IcpResult icp = refine_finely(source, target, candidates[i].T_target_source);
    finalists[i] = {icp, {icp.T_target_source, evidence_of(source, target, icp)}};
  });
  return finalists;
}

double margin_of(const Candidate& best, const std::vector<Finalist>& finalists,
                 const std::vector<Candidate>& candidates) {
  std::vector<Candidate> rivals = candidates;
  for (const Finalist& f : finalists) rivals.push_back(f.candidate);
  return margin_to_others(best, rivals);
}

/// The last step. Where it is a large one, the clouds must lie closer for it, or the ICP's pose stays; half of what the
/// two disagree by is then one more deviation.
LastStep settle(const PreparedScan::Data& source, const PreparedScan::Data& target, const Pose& T_target_source) {
  LastStep last = take_last_step(source, target, T_target_source);
  if (last.moved_m < kSmallStep) return last;
  if (mean_gap(source, target, last.T_target_source) <= mean_gap(source, target, T_target_source)) return last;
  const Eigen::Matrix3d turned = last.T_target_source.linear() * T_target_source.linear().transpose();
  Vector6 half;
  half << log_so3(turned), last.T_target_source.translation() - T_target_source.translation();
  half *= 0.5;
  last.covariance += half * half.transpose();
  last.T_target_source = T_target_source;
  return last;
}

/// The best of the candidates; nothing without a candidate.
std::optional<Conclusion> conclude(const std::vector<Candidate>& candidates, const PreparedScan::Data& source,
                                   const PreparedScan::Data& target, StageListener* stages) {
  begin_stage(stages, "icp");
  const std::vector<Finalist> finalists = refine(candidates, source, target);
  if (finalists.empty()) return std::nullopt;
  begin_stage(stages, "verdict");
  const Finalist& best =
      *std::max_element(finalists.begin(), finalists.end(), [](const Finalist& a, const Finalist& b) {
        return rank_of(a.candidate.evidence) < rank_of(b.candidate.evidence);
      });
  const LastStep last = settle(source, target, best.icp.T_target_source);
  const Observability observability = observe(best.icp);
  const Hold hold = hold_of(source, target, best.icp.T_target_source, observability.translation.vectors);
  Conclusion conclusion{best.icp, last, best.candidate.evidence, hold.facing,
                        open_directions(observability, hold.facing)};
  Evidence& evidence = conclusion.evidence;
  evidence.margin = margin_of(best.candidate, finalists, candidates);
  evidence.held_fit = hold.fit;
  evidence.facing = hold.facing[0];
  evidence.sigma_m = sigma_m(last.covariance);
  evidence.sigma_rad = sigma_rad(last.covariance);
  evidence.matches = last.matches;
  evidence.moved_m = last.moved_m;
  return conclusion;
}

/// As the caller gets it: between the scans' own frames, with covariance and verdict.
RegistrationResult result_of(const Conclusion& conclusion, const PreparedScan::Data& source,
                             const PreparedScan::Data& target) {
  RegistrationResult result;
  result.T_target_source = to_scan_frames(conclusion.last.T_target_source, source, target);
  result.inlier_rmse_m = conclusion.last.rmse_m;
  result.covariance = conclusion.last.covariance;
  result.overlap = conclusion.evidence.agreement.overlap;
  result.open_directions = conclusion.open_directions;
  decide(conclusion.evidence, result);
  return result;
}

/// Whether the scans agree at the pose and the scene leaves a motion open all the same: no search closes it.
bool slides(const Attempt& attempt) {
  return attempt.conclusion && !attempt.conclusion->open_directions.empty() &&
         !contradicts(attempt.conclusion->evidence.agreement);
}

}  // namespace

Attempt attempt_registration(const PreparedScan::Data& source, const PreparedScan::Data& target,
                             const std::optional<OrientationPrior>& prior, StageListener* stages) {
  std::optional<RotationBounds> bounds;
  if (prior) bounds = bounds_of(*prior);
  Attempt attempt;
  attempt.result.reason = "No pose was found that the scans' features agree on.";
  std::vector<Candidate> candidates;
  for (const SearchWidth width : {SearchWidth::mutual, SearchWidth::wide, SearchWidth::thorough}) {
    if (width == SearchWidth::thorough && (!bounds || slides(attempt))) break;
    std::vector<Candidate> more = find_candidates(source, target, bounds, width, stages);
    candidates.insert(candidates.end(), more.begin(), more.end());
    candidates = rank_candidates(std::move(candidates));
    if (auto conclusion = conclude(candidates, source, target, stages)) {
      conclusion->evidence.tracked = prior.has_value();
      attempt.result = result_of(*conclusion, source, target);
      attempt.conclusion = std::move(conclusion);
    }
    if (attempt.result.verdict == Verdict::accepted) break;
  }
  return attempt;
}

}  // namespace scanway::registration
