#include "modules/mapper/core/registration/search.h"

#include <algorithm>
#include <cmath>

#include "common/parallel/blocks.h"
#include "modules/mapper/core/registration/matching.h"
#include "modules/mapper/core/registration/schedule.h"

namespace scanway::registration {
namespace {

constexpr std::size_t kFirstSamples = 400, kSecondSamples = 1500, kFineSamples = 8000;
constexpr std::size_t kSecondLook = 6;  // candidates of the first look that get a second
constexpr double kMinSupport = 0.05;    // of overlap: where scans hardly meet, nothing contradicts either
constexpr double kDistinctMetres = 0.5, kDistinctRadians = 0.09;

bool distinct(const Pose& a, const Pose& b) {
  const Pose d = a.inverse() * b;
  return d.translation().norm() > kDistinctMetres || rotation_angle(d.linear()) > kDistinctRadians;
}

/// Each pose after one more round of ICP, judged by `samples` points a side: the distinct ones, best first.
std::vector<Candidate> look(std::vector<Candidate> candidates, const PreparedScan::Data& source,
                            const PreparedScan::Data& target, const std::optional<RotationBounds>& bounds,
                            std::span<const IcpRound> round, std::size_t samples) {
  for_blocks(candidates.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
    Candidate& c = candidates[i];
    c.T_target_source =
        run_icp(source.surfaces_for(samples), {target.surfaces, target.surface_grid}, c.T_target_source, round)
            .T_target_source;
    c.evidence.agreement = assess(source, target, c.T_target_source, samples);
  });
  std::erase_if(candidates, [&](const Candidate& c) {
    const Agreement& a = c.evidence.agreement;
    return std::min(a.overlap, a.overlap_back) < kMinSupport ||
           (bounds && !within(*bounds, c.T_target_source.linear()));
  });
  return rank_candidates(std::move(candidates));
}

/// The wider searches ask more matches; the right pose may be one of many that a few of them agree on.
ConsensusOptions options_of(SearchWidth width, bool tracked) {
  ConsensusOptions options;
  switch (width) {
    case SearchWidth::mutual:
      break;
    case SearchWidth::wide:
      options.max_matches = 3000;
      options.max_hypotheses = tracked ? 32 : 64;
      if (!tracked) options.max_seeds = options.max_matches;
      break;
    case SearchWidth::thorough:
      options.max_matches = 6000;
      options.max_seeds = 2000;
      options.max_hypotheses = 160;
      break;
  }
  return options;
}

}  // namespace

RotationBounds bounds_of(const OrientationPrior& prior) {
  return {prior.R_target_source, std::max(3.0 * prior.heading_sigma, 0.2), std::max(4.0 * prior.tilt_sigma, 0.11)};
}

std::vector<Candidate> rank_candidates(std::vector<Candidate> all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return rank_of(a.evidence) > rank_of(b.evidence); });
  std::vector<Candidate> kept;
  for (const Candidate& c : all) {
    const bool known = std::any_of(kept.begin(), kept.end(),
                                   [&](const Candidate& k) { return !distinct(k.T_target_source, c.T_target_source); });
    if (!known) kept.push_back(c);
  }
  return kept;
}

std::vector<Candidate> find_candidates(const PreparedScan::Data& source, const PreparedScan::Data& target,
                                       const std::optional<RotationBounds>& bounds, SearchWidth width,
                                       StageListener* stages) {
  begin_stage(stages, "matching");
  std::optional<Eigen::Matrix3f> R;
  if (bounds) R = bounds->R_target_source.cast<float>();
  const bool mutual = width == SearchWidth::mutual;
  const std::vector<Match> matches = match_keypoints(source.keypoints, target.keypoints, R, mutual);
  begin_stage(stages, "hypotheses");
  const std::vector<Hypothesis> hypotheses =
      find_hypotheses(source.keypoints, target.keypoints, matches, bounds, options_of(width, bounds.has_value()));
  begin_stage(stages, "checks");
  std::vector<Candidate> all;
  for (const Hypothesis& h : hypotheses) all.push_back({h.T_target_source, {}});
  all = look(std::move(all), source, target, bounds, kFirstRound, kFirstSamples);
  if (all.size() > kSecondLook) all.resize(kSecondLook);
  return look(std::move(all), source, target, bounds, kSecondRound, kSecondSamples);
}

IcpResult refine_finely(const PreparedScan::Data& source, const PreparedScan::Data& target,
                        const Pose& T_target_source) {
  return run_icp(source.surfaces, {target.surfaces, target.surface_grid}, T_target_source, kFineRounds);
}

Evidence evidence_of(const PreparedScan::Data& source, const PreparedScan::Data& target, const IcpResult& icp) {
  Evidence evidence;
  evidence.agreement = assess(source, target, icp.T_target_source, kFineSamples);
  evidence.rmse_m = icp.rmse_m;
  evidence.observability = observe(icp).weakest();
  return evidence;
}

double margin_to_others(const Candidate& best, const std::vector<Candidate>& others) {
  double margin = kMaxMargin;
  for (const Candidate& other : others) {
    if (!distinct(best.T_target_source, other.T_target_source)) continue;
    margin = std::min(margin, rank_of(best.evidence) - rank_of(other.evidence));
  }
  return margin;
}

}  // namespace scanway::registration
