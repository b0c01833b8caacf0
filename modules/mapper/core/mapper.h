#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/cloud/sweep.h"
#include "common/geometry/pose.h"
#include "common/progress/stages.h"
#include "common/robot/robot.h"
#include "common/time/utime.h"
#include "modules/mapper/core/map.h"
#include "modules/mapper/core/registration/registration.h"

namespace scanway {

/// Where an accepted sweep was taken.
struct TrajectoryPoint {
  Utime utime = 0;
  Pose X_map_sweep = Pose::Identity();
};

/// What became of one sweep.
struct SweepResult {
  std::string name;
  Utime utime = 0;
  Verdict verdict = Verdict::refused;
  std::string reason;                   ///< One sentence for people.
  std::string target;                   ///< Name of the sweep it was registered against; empty for the first.
  RegistrationResult registration;      ///< Against `target`; of the first sweep: the identity, with probability 1.
  Pose X_map_sweep = Pose::Identity();  ///< Of an accepted sweep.
  MapChange change;                     ///< Of an accepted sweep; else the version that stayed.
};

/// The mapper: sweeps in, in the order of their time, a map out. A refused sweep changes no product.
class Mapper {
 public:
  explicit Mapper(const Robot& robot, std::uint64_t seed = 1);

  /// The whole method: prepare, register against the last accepted sweep (or, refused there, one of the two before it),
  /// and merge into every product. Stages: prepare, coarse, fine, merge, octomap, ground, cost_map, embodiment.
  SweepResult add(const Sweep& sweep, StageListener* stages = nullptr);

  const Map& map() const { return map_; }
  const std::vector<TrajectoryPoint>& trajectory() const { return trajectory_; }
  const std::vector<SweepResult>& results() const { return results_; }  ///< One a sweep, accepted or not.

 private:
  struct AcceptedSweep {
    std::string name;
    PreparedScan scan;
    std::optional<Eigen::Quaterniond> R_world_sweep;
    Pose X_map_sweep;
  };

  SweepResult place_first(const Sweep& sweep, const PreparedScan& scan) const;
  SweepResult place(const Sweep& sweep, const PreparedScan& scan, StageListener* stages) const;
  std::optional<OrientationPrior> prior(const Sweep& source, const AcceptedSweep& target) const;

  Robot robot_;
  RegistrationConfig registration_;
  Map map_;
  std::vector<AcceptedSweep> targets_;  ///< The last accepted sweeps, newest first.
  std::vector<TrajectoryPoint> trajectory_;
  std::vector<SweepResult> results_;
};

}  // namespace scanway
