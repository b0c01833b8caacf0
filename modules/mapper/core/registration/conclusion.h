#pragma once

#include <optional>

#include "modules/mapper/core/registration/last_step.h"
#include "modules/mapper/core/registration/search.h"

namespace scanway::registration {

/// The best of the candidates, finely registered, with everything that its verdict rests on.
struct Conclusion {
  IcpResult icp;
  LastStep last;
  Evidence evidence;
  Eigen::Vector3d facing = Eigen::Vector3d::Zero();  ///< See Hold, along the axes that are known from least to best.
  std::vector<std::string> open_directions;
};

struct Attempt {
  RegistrationResult result;
  std::optional<Conclusion> conclusion;  ///< Nothing if no pose was found to conclude from.
};

/// Candidates, the last ICP, the verdict: first with the matches that answer each other, and if that is refused with
/// many more; most of all with a tracker, which tells far more poses apart. Both scans without defect.
Attempt attempt_registration(const PreparedScan::Data& source, const PreparedScan::Data& target,
                             const std::optional<OrientationPrior>& prior, StageListener* stages);

}  // namespace scanway::registration
