#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "common/cloud/sweep.h"
#include "common/geometry/pose.h"
#include "common/progress/stages.h"
#include "common/robot/robot.h"
#include "modules/mapper/core/registration/registration.h"

namespace scanway {

/// A sweep of the map.
struct PlacedSweep {
  std::string name;
  PreparedScan scan;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< The sensor's centre in the sweep's frame.
  std::optional<Eigen::Quaterniond> R_world_sweep;
  int session = 0;  ///< Trackers of two sessions share no heading.
  Pose X_map_sweep = Pose::Identity();
  bool stood_still = false;  ///< The robot, while it was taken, as another sweep confirms.
  bool withdrawn = false;    ///< Nothing is registered to it any more.
};

/// Where the tracker says that up is, in the sweep's frame.
std::optional<Eigen::Vector3d> up_of(const PlacedSweep& sweep);

/// A sweep registered to one of the map's.
struct Link {
  std::size_t target = 0;
  RegistrationResult registration;
};

struct Location {
  std::vector<Link> links;                ///< Those that were accepted, as they were found.
  std::optional<std::size_t> refused_by;  ///< Of a sweep without links: the target that `refusal` is about.
  std::optional<RegistrationResult> refusal;
  std::size_t searched = 0;  ///< At how many of the map's sweeps it was looked for.
};

/// Where a sweep belongs among those of the map. It is looked for where the robot was last, then ever farther from
/// there, until a sweep takes it; then it is registered to those that, by the pose that this gives, see most of what it
/// sees. Each registration is a search of its own, so that they can contradict each other. The more places were asked,
/// the surer the one that takes it must be, or a second one must take it, too.
class Locator {
 public:
  Locator(const Robot& robot, const RegistrationConfig& config) : tracker_(robot.tracker), config_(config) {}

  /// `map` must hold a sweep that is not withdrawn.
  Location locate(const PlacedSweep& sweep, const std::vector<PlacedSweep>& map, StageListener* stages) const;

 private:
  using Sweeps = std::vector<PlacedSweep>;
  struct Found {
    Link link;
    bool certain = false;
  };

  std::optional<Found> find(const PlacedSweep& sweep, const Sweeps& map, Location& location,
                            StageListener* stages) const;
  RegistrationResult link(const PlacedSweep& sweep, const Sweeps& map, std::size_t target, StageListener* stages) const;
  std::optional<OrientationPrior> prior(const PlacedSweep& sweep, const Sweeps& map, std::size_t target) const;

  Robot::Tracker tracker_;
  RegistrationConfig config_;
};

}  // namespace scanway
