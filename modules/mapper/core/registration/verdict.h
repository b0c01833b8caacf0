#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "modules/mapper/core/registration/agreement.h"
#include "modules/mapper/core/registration/eigen3.h"
#include "modules/mapper/core/registration/icp.h"

namespace scanway::registration {

constexpr double kMaxMargin = 5.0;

/// What the verdict rests on.
struct Evidence {
  Agreement agreement;
  double rmse_m = 0.0;
  bool tracked = false;        ///< Whether a tracker's orientation bounded the search.
  double margin = kMaxMargin;  ///< Rank less that of the second-best distinct pose.
  double held_fit = 0.0;       ///< See Hold.
  double facing = 0.0;         ///< See Hold, along the direction that is known least.
  double sigma_m = 1.0;        ///< Of the translation and the rotation, by the last step.
  double sigma_rad = 0.1;
  std::size_t matches = 0;     ///< That these rest on: of few, the deviations are not known well themselves.
  double moved_m = 1.0;        ///< By the last step: two estimators that agree are seldom both wrong.
  double observability = 0.0;  ///< Of the least constrained direction: its share of the information, 1/3 at best.
};

/// Log-odds of a pose by how well the scans agree there, without its rivals: what poses are ranked by.
double rank_of(const Evidence& evidence);

/// The probability that the pose is right within 0.1 m and 0.5 degrees: that it is the right one of the places that
/// look alike, by how well the scans agree there and elsewhere, times that it is precise enough, by the last step. It
/// is never surer than the second-best pose allows, nor than the number of surfaces that hold it where it is held
/// least.
double probability_right(const Evidence& evidence);

/// What the matched surfaces know of each motion while all others are free.
struct Observability {
  Eigen3 translation;  ///< Axes, and each one's share of the information: 1/3 of all at best.
  Eigen3 rotation;     ///< Axes, and each one's squared lever in metres.
  double weakest() const { return std::max(0.0, translation.values[0]); }
};
Observability observe(const IcpResult& icp);

/// The motions that the scene leaves open, by name: of which little is known, and what is known may be noise.
/// `facing`: see Hold, along the axes of translation.
std::vector<std::string> open_directions(const Observability& observability, const Eigen::Vector3d& facing);

/// Whether either scan saw through too much of what the other shows.
bool contradicts(const Agreement& agreement);

/// Accepted or refused, and one sentence why; by `result.open_directions`, too.
void decide(const Evidence& evidence, RegistrationResult& result);

}  // namespace scanway::registration
