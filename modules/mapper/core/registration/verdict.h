#pragma once

#include <string>
#include <vector>

#include "modules/mapper/core/registration/agreement.h"
#include "modules/mapper/core/registration/icp.h"

namespace scanway::registration {

constexpr double kMaxMargin = 5.0;

/// What the verdict rests on.
struct Evidence {
  Agreement agreement;
  double rmse_m = 0.0;
  bool tracked = false;        ///< Whether a tracker's orientation bounded the search.
  double margin = kMaxMargin;  ///< Rank less that of the second-best distinct pose.
  double held_fit = 0.0;       ///< Surface fit of the direction that is held worst: see held_fit().
  double sigma_m = 1.0;        ///< Of the translation and the rotation, by the last step.
  double sigma_rad = 0.1;
  double moved_m = 1.0;        ///< By the last step: two estimators that agree are seldom both wrong.
  double observability = 0.0;  ///< Of the least constrained direction: its share of the information, 1/3 at best.
};

/// Log-odds of a pose by how well the scans agree there, without its rivals: what poses are ranked by.
double rank_of(const Evidence& evidence);

/// The probability that the pose is right within 0.1 m and 0.5 degrees: that it is the right one of the places that
/// look alike, by how well the scans agree there and elsewhere, times that it is precise enough, by the last step.
double probability_right(const Evidence& evidence);

/// Which motions the matched surfaces leave open.
struct Observability {
  double weakest = 0.0;  ///< Smallest share of the information over the directions of translation; 1/3 at best.
  std::vector<std::string> open_directions;
};
Observability observe(const IcpResult& icp);

/// Accepted or refused, and one sentence why.
void decide(const Evidence& evidence, const Observability& observability, RegistrationResult& result);

}  // namespace scanway::registration
