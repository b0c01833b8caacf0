#pragma once

#include <string>
#include <vector>

#include "modules/mapper/core/registration/agreement.h"
#include "modules/mapper/core/registration/icp.h"

namespace scanway::registration {

/// What the verdict rests on.
struct Evidence {
  Agreement agreement;
  double rmse_m = 0.0;
  double margin = 1.0;          ///< Score less that of the second-best distinct hypothesis; at most 1.
  double observability = 0.0;   ///< Of the least constrained direction: its share of the information, 1/3 at best.
};

/// The probability that the pose is right within 0.1 m and 0.5 degrees.
double probability_right(const Evidence& evidence);

/// Which motions the matched surfaces leave open.
struct Observability {
  double weakest = 0.0;  ///< Smallest share of the information, over translations and (at the mean lever) rotations.
  std::vector<std::string> open_directions;
};
Observability observe(const IcpResult& icp);

/// Accepted or refused, and one sentence why.
void decide(const Evidence& evidence, const Observability& observability, RegistrationResult& result);

}  // namespace scanway::registration
