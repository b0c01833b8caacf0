#include "modules/mapper/core/registration/registration.h"

#include "modules/mapper/core/registration/conclusion.h"
#include "modules/mapper/core/registration/prepared_scan.h"

namespace scanway {
namespace {

RegistrationResult refused(std::string reason) {
  RegistrationResult result;
  result.reason = std::move(reason);
  return result;
}

}  // namespace

RegistrationResult register_scans(const PreparedScan& source, const PreparedScan& target,
                                  const std::optional<OrientationPrior>& prior, const RegistrationConfig&,
                                  StageListener* stages) {
  if (!source.data().defect.empty()) return refused("The source " + source.data().defect + ".");
  if (!target.data().defect.empty()) return refused("The target " + target.data().defect + ".");
  RegistrationResult result = registration::attempt_registration(source.data(), target.data(), prior, stages).result;
  begin_stage(stages, "");
  return result;
}

}  // namespace scanway
